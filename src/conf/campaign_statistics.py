"""Intervals of shares for the scripts that check campaigns. Nothing is shared with the program."""
import math
from collections import defaultdict


def wilson(share, n, z=1.959963984540054):
    middle = (share + z * z / (2 * n)) / (1 + z * z / n)
    half = z / (1 + z * z / n) * math.sqrt(share * (1 - share) / n + z * z / (4 * n * n))
    return max(0, middle - half), min(1, middle + half)


def worth(runs_of_group, share, worlds):
    """The number of independent runs that some runs are worth: n by the design effect of their worlds."""
    sums = defaultdict(float)
    for run in runs_of_group:
        sums[run["world" if worlds > 1 else "block"]] += int(run["carried_on"]) - share
    n, clusters, squares = len(runs_of_group), len(sums), len(runs_of_group) * share * (1 - share)
    if n == clusters:
        return n
    if clusters == 1:
        return 1
    if squares < 1e-12:
        return clusters
    effect = sum(s * s for s in sums.values()) * clusters / (clusters - 1) / squares
    return n / max(1, effect)
