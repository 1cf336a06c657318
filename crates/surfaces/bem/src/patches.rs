//! Contact patches: pixels in contact that hang together.

/// Sizes of the patches in pixels, largest first. Pixels hang together over edges, not corners,
/// and over the seams of a periodic map.
pub(crate) fn patches(
    touching: &[bool],
    [rows, columns]: [usize; 2],
    periodic: bool,
) -> Vec<usize> {
    // A forest: every pixel points to one of its patch, the root to itself.
    let mut parent: Vec<usize> = (0..touching.len()).collect();
    let join = |parent: &mut Vec<usize>, a: usize, b: usize| {
        if touching[a] && touching[b] {
            let (a, b) = (root(parent, a), root(parent, b));
            parent[a.max(b)] = a.min(b);
        }
    };
    for i in 0..rows {
        for j in 0..columns {
            let at = i * columns + j;
            if j + 1 < columns || periodic {
                join(&mut parent, at, i * columns + (j + 1) % columns);
            }
            if i + 1 < rows || periodic {
                join(&mut parent, at, (i + 1) % rows * columns + j);
            }
        }
    }
    let mut sizes = vec![0; touching.len()];
    for at in (0..touching.len()).filter(|&at| touching[at]) {
        sizes[root(&mut parent, at)] += 1;
    }
    sizes.retain(|&size| size > 0);
    sizes.sort_unstable_by(|a, b| b.cmp(a));
    sizes
}

/// Root of a pixel; halves the paths on the way.
fn root(parent: &mut [usize], mut at: usize) -> usize {
    while parent[at] != at {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn over_edges_and_seams_but_not_over_corners() {
        let map = "
            #..#.
            .#...
            .##..
            #...#";
        let touching: Vec<bool> =
            map.chars().filter(|c| "#.".contains(*c)).map(|c| c == '#').collect();
        assert_eq!(patches(&touching, [4, 5], false), [3, 1, 1, 1, 1]);
        // The corners meet over both seams, the rest does not.
        assert_eq!(patches(&touching, [4, 5], true), [3, 3, 1]);
        assert_eq!(patches(&[false; 20], [4, 5], true), []);
        assert_eq!(patches(&[true; 20], [4, 5], false), [20]);
    }
}
