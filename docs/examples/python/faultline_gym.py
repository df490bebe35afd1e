"""A Gymnasium environment over ``faultline serve``.

Observation: one number in [0, 1] for each sensor, the reading as a share of its range; 1 for nothing within range, and
1 for a sensor that does not answer, followed by one 0 or 1 for each sensor that tells whether it answered.
Action: the voltage of each side as a share of the supply, in [-1, 1]. Reward: the distance driven ahead along the
robot's heading while the left sensor reads close to the wanted distance, less 1 for a collision. Nothing is rendered.
"""

import gymnasium
import numpy

import faultline


class WallFollowingEnv(gymnasium.Env):
    """One episode is one run of a scenario; it ends early at the first contact."""

    metadata = {"render_modes": []}

    def __init__(self, scenario="scenarios/office.xml", ticks=10, wanted_distance=0.25, command=None):
        if not wanted_distance > 0:
            raise ValueError(f"wanted_distance is {wanted_distance}; expected a number of metres above 0")
        self._simulator = faultline.Simulator(scenario, truth=True, command=command)
        self._ticks = ticks
        self._wanted = wanted_distance
        robot = self._simulator.hello["robot"]
        self._supply = robot["max_voltage_v"]
        self._ranges = {sensor["id"]: sensor["range_m"] for sensor in robot["sensors"]}
        if "left" not in self._ranges:
            self._simulator.close()
            raise ValueError('the reward needs a sensor "left"; the robot has ' + (", ".join(self._ranges) or "none"))
        self._pose = None
        count = len(self._ranges)
        self.observation_space = gymnasium.spaces.Box(0.0, 1.0, (2 * count,), numpy.float32)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (2,), numpy.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        run_seed = int(self.np_random.integers(0, 2**31))
        sight = self._simulator.reset(seed=run_seed)
        self._pose = sight.truth["pose"]
        return self._observation(sight), {"seed": run_seed}

    def step(self, action):
        if self._pose is None:
            raise RuntimeError("there is no episode, or it is over; reset begins one")
        if numpy.shape(action) != (2,):
            shape = numpy.shape(action)
            raise ValueError(f"the action has the shape {shape}; expected (2,), for the left and the right side")
        left, right = (float(share) * self._supply for share in numpy.clip(action, -1.0, 1.0))
        sight = self._simulator.step(faultline.volts(left, right), self._ticks)
        collided = bool(sight.truth["collided"])
        reward = self._progress(sight) - (1.0 if collided else 0.0)
        if collided or self._simulator.done:
            self._pose = None
        return self._observation(sight), reward, collided, bool(self._simulator.done and not collided), {}

    def _progress(self, sight):
        before, self._pose = self._pose, sight.truth["pose"]
        heading = before["heading_rad"]
        ahead = (self._pose["x_m"] - before["x_m"]) * numpy.cos(heading)
        ahead += (self._pose["y_m"] - before["y_m"]) * numpy.sin(heading)
        error = abs(sight.distance("left", otherwise=self._ranges["left"]) - self._wanted)
        return float(ahead * max(0.0, 1.0 - error / self._wanted))

    def _observation(self, sight):
        shares = [min(1.0, sight.distance(name, reach) / reach) for name, reach in self._ranges.items()]
        answers = [0.0 if sight[name] is faultline.NO_ANSWER else 1.0 for name in self._ranges]
        return numpy.array(shares + answers, dtype=numpy.float32)

    def render(self):
        raise NotImplementedError("this environment has no pictures; run --film makes one of a run with the same seed")

    def close(self):
        self._simulator.close()


gymnasium.register("faultline/WallFollowing-v0", entry_point=WallFollowingEnv)
