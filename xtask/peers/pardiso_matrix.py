"""PARDISO of MKL on a symmetric matrix that ours wrote: analysis, factor and solve, each timed.

    python pardiso_matrix.py FOLDER

FOLDER has matrix.mtx (Matrix Market, lower triangle, positive definite) and right.txt. Prints one line of JSON: unknowns, the norm of the
solution, ms of analysis, factor and solve by the clock, medians of five. Cholesky's factor (mtype 2), which needs no pivots.
"""

import json
import os
import sys
from statistics import median
from time import perf_counter

import numpy as np
import pypardiso
import scipy.io
import scipy.sparse

folder = sys.argv[1]
matrix = scipy.sparse.csr_matrix(scipy.sparse.triu(scipy.io.mmread(os.path.join(folder, "matrix.mtx")).tocsr()))
right = np.loadtxt(os.path.join(folder, "right.txt"))
solver = pypardiso.PyPardisoSolver(mtype=2)


def timed(phase, trials=5):
    times, answer = [], None
    for _ in range(trials):
        solver.set_phase(phase)
        start = perf_counter()
        answer = solver._call_pardiso(matrix, right.reshape(-1, 1))
        times.append(1e3 * (perf_counter() - start))
    return median(times), answer


analysis, _ = timed(11)
factor, _ = timed(22)
solve, answer = timed(33)
said = {"answers": [float(np.linalg.norm(answer))], "unknowns": len(right)}
print(json.dumps(said | {"analysis": analysis, "factor": factor, "solve": solve}))
