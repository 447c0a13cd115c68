"""A column of water, 1 m wide and 2 m high, falls in a tank of 6 m: PySPH's example dam_break_2d, scheme wcsph.

    python pysph_dam.py SPACING DURATION THREADS FOLDER

The example's numbers (Wendland C2, h = 1.3 spacings, alpha = .1, sound 10 sqrt(2 g H), boundary particles in four layers), with
particles half a spacing from walls and the mass of a particle that of its spacing. Prints one line of JSON: the front [m] and the
kinetic energy [J/m] at the end, ns a step and fluid particle by the clock and by the processor, from the first step on, no output.
"""

import json
import sys
from time import perf_counter, process_time

spacing, duration, threads, folder = float(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3]), sys.argv[4]

import numpy as np  # noqa: E402
from pysph.base.utils import get_particle_array  # noqa: E402
from pysph.examples import dam_break_2d as example  # noqa: E402
from pysph.tools.geometry import get_2d_tank  # noqa: E402

example.dx, example.h, example.m = spacing, example.hdx * spacing, spacing**2 * example.ro


class Dam(example.DamBreak2D):
    began = None

    def create_particles(self):
        half = 0.5 * spacing
        x, y = np.mgrid[half:1:spacing, half:2:spacing]
        fluid = get_particle_array(name="fluid", x=x.ravel(), y=y.ravel(), h=example.h, m=example.m, rho=example.ro)
        # The layer next to the water lies half a spacing outside of the tank.
        xt, yt = get_2d_tank(dx=spacing, length=6 + spacing, height=3, base_center=[3, -half], num_layers=4)
        tank = get_particle_array(name="boundary", x=xt, y=yt, h=example.h, m=example.m, rho=example.ro)
        self.scheme.setup_properties([fluid, tank])
        self.kernel_corrections(fluid, tank)
        return [fluid, tank]

    def pre_step(self, solver):
        if self.began is None:
            self.began = perf_counter(), process_time(), solver.count


dam = Dam()
words = [f"--dx={spacing}", f"--tf={duration}", "--disable-output", "--pfreq=1000000", f"--directory={folder}"]
dam.run(words + (["--openmp"] if threads > 1 else ["--no-openmp"]))
wall, processor = perf_counter() - dam.began[0], process_time() - dam.began[1]
fluid = dam.particles[0]
work = 1e-9 * (dam.solver.count - dam.began[2]) * fluid.get_number_of_particles()
kinetic = 0.5 * float(np.sum(fluid.m * (fluid.u**2 + fluid.v**2)))
print()
print(
    json.dumps(
        {
            "answers": [float(fluid.x.max()) + 0.5 * spacing, kinetic],
            "cost": wall / work,
            "processor": processor / work,
            "steps": dam.solver.count,
            "time": dam.solver.t,
        }
    )
)
