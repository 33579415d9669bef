"""A sweep on a Ray cluster: `recede.sweep` takes anything that has `submit` like `concurrent.futures`.

    python ray_sweep.py scene.ron force 0.001 0.01 10000
"""

import sys

import numpy as np
import ray
import recede


class Future:
    """A task of Ray with the methods that `recede.sweep` calls."""

    def __init__(self, reference):
        self._reference = reference

    def result(self):
        return ray.get(self._reference)

    def done(self):
        return bool(ray.wait([self._reference], timeout=0)[0])

    def cancel(self):
        ray.cancel(self._reference)

    def cancelled(self):
        return False

    def exception(self):
        try:
            self.result()
        except Exception as error:
            return error
        return None


class Executor:
    """Hands functions to Ray, one processor each."""

    def submit(self, function, *arguments):
        return Future(ray.remote(function).remote(*arguments))


if __name__ == "__main__":
    path, quantity, start, stop, count = sys.argv[1:]
    ray.init()
    values = np.geomspace(float(start), float(stop), int(count))
    table = recede.sweep(recede.Scene.read(path), {quantity: values}, executor=Executor())
    table.to_csv("rows.csv")
    print(table)
