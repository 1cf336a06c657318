# To be sourced. Says that a check cannot run here, and why: an error under CI=true, else a note.
skip() {
    if [ "${CI:-}" = true ]; then
        echo "error: $1" >&2
        exit 1
    fi
    echo "note: check skipped, $1"
}

# Runs rustup, which may have to download something.
rustup_can() {
    mkdir -p target
    timeout 120 rustup "$@" >target/rustup.log 2>&1 && return
    skip "rustup $* failed: $(tail -n 1 target/rustup.log)"
    return 1
}
