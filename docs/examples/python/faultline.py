"""A client of the protocol "faultline-lines 1", on Python's standard library alone.

As a child of the simulator, with ``faultline run FILE --controller "python3 my.py"``:

    import faultline

    def decide(sight):
        return faultline.velocities(0.2, 0.5 if sight["left"] is None else 0.0)

    faultline.drive_with(decide)

As its parent, for step-and-reset programs:

    with faultline.Simulator("scenarios/office.xml") as simulator:
        sight = simulator.reset(seed=7)
        while not simulator.done:
            sight = simulator.step(faultline.velocities(0.2, 0.1), ticks=10)

Lengths are metres, angles radians, times seconds. A reading is a distance, ``None`` for nothing within range, or
``faultline.NO_ANSWER`` for a sensor that does not answer.
"""

import contextlib
import io
import json
import math
import operator
import os
import shlex
import subprocess
import sys
import weakref

PROTOCOL = 1


class _NoAnswer:
    def __repr__(self):
        return "NO_ANSWER"

    def __reduce__(self):
        # Copies and pickles name this object, so that "is NO_ANSWER" holds for them.
        return "NO_ANSWER"


NO_ANSWER = _NoAnswer()


def volts(left, right, state=None, why=None):
    """Returns a drive message with a voltage for each side."""
    return _with_state({"type": "drive", "left_v": _finite(left), "right_v": _finite(right)}, state, why)


def velocities(v, omega, state=None, why=None):
    """Returns a drive message with a forward velocity (m/s) and a turn rate (rad/s, positive to the left)."""
    return _with_state({"type": "drive", "v_m_s": _finite(v), "omega_rad_s": _finite(omega)}, state, why)


def _finite(number):
    number = float(number)
    if not math.isfinite(number):
        raise ValueError("a drive needs finite numbers, not %r" % number)
    return number


def _with_state(message, state, why):
    if state is not None:
        message["state"] = state
    if why is not None:
        message["why"] = why
    return message


class Sight(dict):
    """The readings of one tick by the ids of the sensors, with ``tick``, ``t``, ``robot`` and, on request, ``truth``."""

    __slots__ = ("tick", "t", "robot", "truth")

    def __missing__(self, sensor):
        raise KeyError("there is no sensor %r; the robot has %s" % (sensor, ", ".join(self)))

    def distance(self, sensor, otherwise):
        """Returns a sensor's distance, or another value if it sees nothing or does not answer."""
        reading = self[sensor]
        return otherwise if reading is None or reading is NO_ANSWER else reading


class _Robot:
    """Keeps the robot of the last message that described it."""

    def __init__(self, hello):
        self.description = hello["robot"]
        self.ids = [sensor["id"] for sensor in self.description["sensors"]]

    def sight(self, message):
        if "robot" in message:
            self.__init__(message)
        readings = message["readings_m"]
        answers = message["answers"]
        if False in answers:
            readings = [reading if answer else NO_ANSWER for reading, answer in zip(readings, answers)]
        sight = Sight(zip(self.ids, readings))
        sight.tick = message["tick"]
        sight.t = message["t_s"]
        sight.robot = self.description
        sight.truth = message.get("truth")
        return sight


# Made once: json.loads and json.dumps take half as long again for a message as these.
_parse = json.JSONDecoder().raw_decode
_encode = json.JSONEncoder(separators=(",", ":")).encode


def _read(line):
    return _parse(line.decode())[0]


def _read_hello(line):
    try:
        hello = _read(line)
        if hello["type"] == "hello":
            _Robot(hello)
            return hello
    except (ValueError, LookupError, TypeError, RecursionError):
        pass
    raise RuntimeError("the first line is not the hello of the simulator: %.80r" % line.decode(errors="replace").rstrip())


def _write(message, stream):
    stream.write((_encode(message) + "\n").encode())
    stream.flush()


def drive_with(decide, name="python", begin=None):
    """Acts as the simulator's child until the run is over: calls ``decide(sight)`` once a tick.

    ``begin(hello)`` is called first, if given. Standard input and output belong to the protocol, so ``input`` finds
    nothing, and ``print`` is redirected to standard error. Returns the ``end`` message, or None if the simulator closed the connection.
    """
    if sys.stdin.isatty():
        print(
            'This program waits for the simulator, which starts it: faultline run FILE --controller "python3 %s"'
            % os.path.basename(sys.argv[0]),
            file=sys.stderr,
        )
    answers = open(sys.stdout.fileno(), "wb", closefd=False)
    sys.stdout = sys.stderr
    messages = sys.stdin.buffer
    sys.stdin = io.StringIO()
    robot = None
    for line in iter(messages.readline, b""):
        message = _read(line) if robot else _read_hello(line)
        kind = message["type"]
        if kind == "observe":
            answer = decide(robot.sight(message))
            if not isinstance(answer, dict):
                raise TypeError(
                    "decide returned %r; it must return faultline.velocities(...) or faultline.volts(...)" % (answer,)
                )
            answer["tick"] = message["tick"]
            _write(answer, answers)
        elif kind == "hello":
            robot = _Robot(message)
            if begin is not None:
                begin(message)
            _write({"type": "ready", "protocol": PROTOCOL, "name": name}, answers)
        elif kind == "end":
            return message
    return None


def default_command():
    """Returns the command that starts the simulator: the environment variable FAULTLINE, or ``faultline``.

    An empty variable is the same as none. A path with blanks stands in double quotes.
    """
    return _split(os.environ.get("FAULTLINE", "")) or ["faultline"]


def _split(command):
    return [word.strip('"') for word in shlex.split(command, posix=os.name == "posix")]


def _end_unclosed(process):
    """Ends a simulator that nobody can close any more, by the end of its input."""
    with contextlib.suppress(OSError):
        process.stdin.close()
    process.stdout.close()
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(timeout=5)


class Simulator:
    """A simulator that is stepped from Python, over ``faultline serve``.

    ``command`` starts the simulator: a list of words, or a text that is split as the variable FAULTLINE is.
    """

    def __init__(self, scenario, truth=False, command=None):
        words = _split(command) if isinstance(command, str) else list(command or ())
        command = (words or default_command()) + ["serve", str(scenario)] + (["--truth"] if truth else [])
        try:
            self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        except FileNotFoundError:
            raise FileNotFoundError(
                "there is no program %r; give the command that starts the simulator, or set FAULTLINE" % command[0]
            ) from None
        weakref.finalize(self, _end_unclosed, self._process).atexit = False
        try:
            self.hello = _read_hello(self._receive())
            self._robot = _Robot(self.hello)
        except BaseException:
            # This is another program, or an interrupt; the caller has no simulator yet that it could close.
            self._process.kill()
            self.close()
            raise
        self.done = False
        self.end = None

    def reset(self, seed=None):
        """Begins a run and returns its first sight."""
        self.done = False
        self.end = None
        return self._ask({"type": "reset"} if seed is None else {"type": "reset", "seed": operator.index(seed)})

    def step(self, drive, ticks=1):
        """Drives for some ticks and returns what is then seen; ``done`` tells whether the run is over."""
        if self.done:
            raise RuntimeError("the run is over (%s); reset begins another one" % self.end["reason"])
        return self._ask(dict(drive, ticks=operator.index(ticks)))

    def _ask(self, message):
        if self._process.stdin.closed:
            raise RuntimeError("the simulator is closed")
        with contextlib.suppress(OSError):  # It has ended, which _receive reports.
            _write(message, self._process.stdin)
        answer = _read(self._receive())
        if answer["type"] == "end":
            self.done = True
            self.end = answer
        return self._robot.sight(answer)

    def _receive(self):
        try:
            line = self._process.stdout.readline()
        except BaseException:
            # An answer that comes after an interrupt would be taken for that of the next request.
            self._process.kill()
            self.close()
            raise
        if not line:
            self.close()
            raise RuntimeError(
                "the simulator has ended with exit code %s; the reason is on its standard error"
                % self._process.returncode
            )
        return line

    def close(self):
        """Ends the simulator."""
        with contextlib.suppress(OSError):
            if not self._process.stdin.closed:
                _write({"type": "close"}, self._process.stdin)
        with contextlib.suppress(OSError):
            self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.close()
