"""Intervals of shares for the scripts that check campaigns. Nothing is shared with the program."""
import math
from collections import Counter, defaultdict

NORMAL = 1.959963984540054


def wilson(share, n, z=NORMAL):
    middle = (share + z * z / (2 * n)) / (1 + z * z / n)
    half = z / (1 + z * z / n) * math.sqrt(share * (1 - share) / n + z * z / (4 * n * n))
    return max(0, middle - half), min(1, middle + half)


def student(freedom):
    """The 0.975 quantile of Student's t, by Simpson's rule over the angle whose tangent is t over the root of the degrees of freedom."""
    def within(limit, steps=2000):
        end = math.atan(limit / math.sqrt(freedom))
        values = [math.cos(end * i / steps) ** (freedom - 1) for i in range(steps + 1)]
        area = end / steps / 3 * (values[0] + values[-1] + 4 * sum(values[1:-1:2]) + 2 * sum(values[2:-1:2]))
        return 2 * area * math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(math.pi)
    low, high = NORMAL, 13
    while high - low > 1e-9:
        middle = (low + high) / 2
        low, high = (middle, high) if within(middle) < 0.95 else (low, middle)
    return low


def factors(runs):
    """The columns of what varies, which are those between the seed and the first result."""
    names = list(runs[0])
    return names[names.index("seed") + 1 : names.index("outcome")]


def identity(run, factors):
    """What only repetitions of a run have in common: the world, the values of the factors, and all results but the hash.

    If the error of the distance was not measured, the hash takes the place of the results."""
    if not run["trajectory_hash"]:
        return run["run"]
    names = list(run)
    results = [name for name in names[names.index("outcome") :] if name != "trajectory_hash"] if run["follow_rms_m"] else ["trajectory_hash"]
    return tuple(run[name] for name in ("world", *factors, *results))


quantiles = {}


def worth(runs_of_group, share, worlds, factors):
    """The number of independent runs that some runs are worth: n by the design effect of their worlds, less for few worlds.

    Repetitions of a run belong to the cluster of the first."""
    clusters, weights, first = defaultdict(list), Counter(), {}
    for run in runs_of_group:
        key = identity(run, factors)
        weights[key] += 1
        cluster, _ = first.setdefault(key, (run["world" if worlds > 1 else "block"], int(run["carried_on"])))
        clusters[cluster].append(int(run["carried_on"]) - share)
    n, count = len(runs_of_group), len(clusters)
    squares = sum((weights[key] * (value - share)) ** 2 for key, (_, value) in first.items())
    if count == 1 or squares < 1e-12:
        return count
    effect = max(1, sum(sum(c) ** 2 for c in clusters.values()) * count / (count - 1) / squares)
    if count not in quantiles:
        quantiles[count] = student(count - 1)
    independent = n * n / sum(w * w for w in weights.values()) / effect * (NORMAL / quantiles[count]) ** 2
    return max(independent, n * n / sum(len(c) ** 2 for c in clusters.values()))
