"""Runs an example of PySPH and writes what its particles do, in the units of the case of sphlab that it is compared with.

    pysph_run.py CASE RESOLUTION FILE [TIME ...]

CASE is a case of `sphlab bench`; RESOLUTION the number of particles along the example's length (0: the example's own); TIMEs [s], in
ascending order, are those of the case at which the particles are written. FILE becomes CSV: a line `# key value` for what was run and
its run time, the names of the columns, and a row a particle and time. Without TIMEs a few steps are made, so that PySPH compiles what
it needs and keeps it.

The seconds are those of the process on the processor while Solver.solve() is at work: compiling and making particles come before it,
and what is noted here at the times wanted is taken off.
"""

import importlib
import sys
import tempfile
import time


class Example:
    """An example of PySPH: its module, its class, its arguments, and how its units become those of the case."""

    def __init__(self, module, name, scheme, arguments=(), resolution=None, speed=1.0, pace=1.0, at_one=False):
        self.module = module
        self.name = name
        self.scheme = scheme          # for people
        self.arguments = list(arguments)
        self.resolution = resolution  # the option that takes it
        self.speed = speed            # what its velocities are multiplied by, and with the square its pressures
        self.pace = pace              # what its times are multiplied by
        self.at_one = at_one          # moved along x so that the fluid, half a particle around the outermost included, starts up to 1


# The example Poiseuille has the width 1, nu = 0.01 and nu Re/width in the middle once steady; the case has 1, 1 and 1.
NU = 0.01
GREATEST = 0.0125 * NU

EXAMPLES = {
    "taylor-green": Example("taylor_green", "TaylorGreen", "EDAC", ["--scheme", "edac", "--perturb", "0.2"], "--nx"),
    "elliptic-drop": Example("elliptical_drop", "EllipticalDrop", "WCSPH", [], "--nx"),
    "still-water": Example("hydrostatic_tank", "HydrostaticTank", "WCSPH with Adami's walls"),
    "water-column": Example("dam_break_2d", "DamBreak2D", "WCSPH", at_one=True),
    "poiseuille": Example("poiseuille", "PoiseuilleFlow", "TVF", speed=1 / GREATEST, pace=NU),
}


class Recorder:
    """Takes the place of the solver's output: the particles at its times, and how long it took to note them."""

    def __init__(self, example, solver):
        self.example = example
        self.solver = solver
        self.fluid = next(array for array in solver.particles if array.name == "fluid")
        self.rows = []
        self.seconds = 0.0
        self.shift = 0.0
        if example.at_one:
            x, m, rho = self.fluid.get("x", "m", "rho")
            self.shift = 1 - (max(x) + 0.5 * (m[0] / rho[0]) ** 0.5)

    def __call__(self):
        start = time.process_time()
        x, y, u, v, m, p = self.fluid.get("x", "y", "u", "v", "m", "p")  # without the ghosts
        t, speed = self.solver.t * self.example.pace, self.example.speed
        columns = (x + self.shift, y, u * speed, v * speed, m, p * speed ** 2)
        self.rows.extend((t, *values) for values in zip(*columns))
        self.seconds += time.process_time() - start


def run(example, resolution, times, folder):
    module = importlib.import_module("pysph.examples." + example.module)
    app = getattr(module, example.name)()
    arguments = example.arguments + ["--directory", folder, "--no-openmp"]
    if resolution > 0:
        arguments += [example.resolution, str(resolution)]
    times = [t / example.pace for t in times]
    arguments += ["--tf", repr(times[-1])] if times else ["--max-steps", "3"]
    app.setup(arguments)
    solver = app.solver
    solver.set_output_at_times(times)
    solver.set_print_freq(10 ** 9)
    recorder = Recorder(example, solver)
    solver.dump_output = recorder
    start = time.process_time()
    solver.solve(False)
    seconds = time.process_time() - start - recorder.seconds
    count = recorder.fluid.get_number_of_particles(True)
    return recorder.rows, {"seconds": seconds, "steps": solver.count, "particles": count}


def main():
    example, resolution, file = EXAMPLES[sys.argv[1]], int(sys.argv[2]), sys.argv[3]
    times = [float(t) for t in sys.argv[4:]]
    with tempfile.TemporaryDirectory() as folder:
        rows, facts = run(example, resolution, times, folder)
    import pysph
    facts.update(version=pysph.__version__, example=example.module, scheme=example.scheme)
    with open(file, "w") as out:
        for key, value in facts.items():
            print("#", key, value, file=out)
        print("t [s],x [m],y [m],vx [m/s],vy [m/s],mass [kg/m],pressure [Pa]", file=out)
        for row in rows:
            print(",".join(repr(float(value)) for value in row), file=out)


if __name__ == "__main__":
    main()
