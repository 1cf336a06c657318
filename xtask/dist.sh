#!/usr/bin/env bash
# Files to install in target/dist: the Python wheel, the program as an archive, the page as a zip,
# checksums. Each is tried where it will be used: without cargo on the path. With --quick without
# optimisation, and the program with shared libraries, in target/dist-quick, so that no quick build
# is published.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
version=$(sed -n 's/^version = "\(.*\)"$/\1/p' Cargo.toml | head -n 1)
if [ "${1:-}" = --quick ]; then quick=-quick profile=quick; else quick= profile=release; fi
missing=
python3 -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2>/dev/null ||
    missing+=$'\nPython 3.10 or newer with venv and pip: `apt install python3 python3-venv`'
target=x86_64-unknown-linux-musl
[ $quick ] || rustup target list --installed 2>/dev/null | grep -qx $target ||
    missing+=$'\n'"the Rust target $target: \`rustup target add $target\`"
[ -z "$missing" ] || { echo "Error: missing for this task:$missing" >&2; exit 1; }
dist=$root/target/dist$quick
tools=$root/target/dist-tools/bin
trial=$(mktemp -d)
trap 'rm -r "$trial"' EXIT
rm -rf "$dist"
mkdir -p "$dist"
pip=(-m pip install --quiet --disable-pip-version-check)
.ci/licences

# The wheel, for any Linux with glibc 2.17 and Python 3.10, or newer. zig is found on the path.
if ! [ -x "$tools/maturin" ] || ! [ -x "$tools/python-zig" ]; then
    python3 -m venv target/dist-tools
    "$tools/python" "${pip[@]}" 'maturin>=1.9.4,<2' ziglang
fi
package=crates/apps/python
mkdir -p $package/licenses
cp LICENSE-APACHE LICENSE-MIT $package/licenses
.ci/licences asperity-python x86_64-unknown-linux-gnu >$package/licenses/THIRD-PARTY.txt
PATH="$tools:$PATH" maturin build --zig --compatibility manylinux2014 --profile "$profile" \
    --target x86_64-unknown-linux-gnu --quiet --out "$dist" --manifest-path $package/Cargo.toml
wheel=$(echo "$dist"/*-abi3-manylinux*2014_x86_64*.whl)
python3 -m venv "$trial/venv"
"$trial/venv/bin/python" "${pip[@]}" "$wheel"
# What a user without Rust does: imports and one answer.
(cd "$trial" && PATH=$trial/venv/bin python - <<'PYTHON'
import pathlib, shutil
import asperity
assert shutil.which("cargo") is None, "cargo is on the path"
assert "site-packages" in asperity.__file__, asperity.__file__
steel = asperity.Body(210e9, 0.3, hardness=2e9)
scene = asperity.Scene(
    interface=asperity.Interface.between(steel, steel),
    surface=asperity.Surface(2e-4, 2e8, 1e-6),
    nominal_area=1e-4,
)
curve = asperity.model("ke").solve(scene, separation=[1.0, 2.0, 3.0], quantities=["force", "area"])
assert f"{curve.force[1]:.2f} {curve.area[1]:.3e}" == "216.94 1.427e-07", (curve.force, curve.area)
PYTHON
)

# The program without shared libraries, with licences, to be unpacked over
# ~/.local or /usr/local; a quick build is that of the tests.
if [ $quick ]; then
    cargo build --bin asperity --workspace
    built=target/debug
else
    cargo build --bin asperity --package asperity-cli --profile program --target $target
    built=target/$target/program
fi
name=asperity-$version-x86_64-linux
texts=$dist/$name/share/doc/asperity
mkdir -p "$dist/$name/bin" "$texts"
cp $built/asperity "$dist/$name/bin"
cp crates/apps/cli/README.md crates/asperity/CHANGELOG.md LICENSE-APACHE LICENSE-MIT "$texts"
.ci/licences asperity-cli x86_64-unknown-linux-musl >"$texts/THIRD-PARTY.txt"
program() {
    env -i "$dist/$name/bin/asperity" "$@"
}
(cd "$trial" && program init scene.toml)
answer=$(cd "$trial" && program --quiet curve scene.toml --model ke --load 100)
[ "$(wc -l <<<"$answer")" -gt 1 ] || { echo "error: the program gave no answer: $answer" >&2; exit 1; }
# The same folder gives the same bytes, and its files belong to nobody.
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime='1980-01-01 00:00Z' \
    --use-compress-program='gzip -n' --create --file "$dist/$name.tar.gz" --directory "$dist" "$name"
rm -r "${dist:?}/$name"

# The page, if it was built, with the guide and the documentation of both interfaces.
if [ -f target/page/index.html ]; then
    RUSTDOCFLAGS='-D warnings' cargo doc --workspace --no-deps
    rm -rf target/page/rust target/page/python
    cp -r target/doc target/page/rust
    rm -f target/page/rust/.lock
    "$trial/venv/bin/python" "${pip[@]}" pdoc
    "$trial/venv/bin/python" -m pdoc --docformat numpy asperity --output-directory target/page/python
    cargo xtask guide
    for file in rust/asperity/index.html python/asperity.html guide/index.html; do
        [ -s target/page/$file ] || { echo "target/page/$file is missing" >&2; exit 1; }
    done
    name=asperity-$version-page
    cp -r target/page "$dist/$name"
    find "$dist/$name" -exec touch --date '1980-01-01 00:00Z' {} +
    (cd "$dist" && TZ=UTC python3 -m zipfile --create "$name.zip" "$name/")
    rm -r "${dist:?}/$name"
else
    echo "note: no target/page: the page is left out; run cargo xtask page" >&2
fi

(cd "$dist" && sha256sum -- * >SHA256SUMS)
ls -d "$dist"/*
