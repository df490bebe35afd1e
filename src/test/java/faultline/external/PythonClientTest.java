package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import faultline.JavaProcess;
import faultline.PythonProcess;
import faultline.PythonProcess.Output;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The Python examples, run as the documentation says. */
@Timeout(120)
class PythonClientTest {

    /** Python code that replaces the packages that the environment needs by empty ones. */
    private static final String WITHOUT_PACKAGES =
            """
            import sys, types
            for name in ("gymnasium", "numpy"):
                sys.modules[name] = types.ModuleType(name)
            sys.modules["gymnasium"].Env = object
            sys.modules["gymnasium"].register = lambda *name, **entry: None
            """;

    private static final Path EXAMPLES = Path.of("docs/examples/python");

    @BeforeEach
    void requirePython() throws Exception {
        PythonProcess.require();
    }

    @Test
    void theExampleFollowerFollowsTheWallOfTheYard() throws Exception {
        SimulationSetup setup = Scenario.load(Path.of("scenarios/yard.xml")).setup();
        RunResult first = follow(setup);
        assertTrue(first.collision().isEmpty());
        assertTrue(first.coverage().orElseThrow() > 0.8, () -> "coverage " + first.coverage());
        assertEquals(first.trajectoryHash(), follow(setup).trajectoryHash());
    }

    private static RunResult follow(SimulationSetup setup) throws IOException {
        List<String> errors = new CopyOnWriteArrayList<>();
        RunResult result = run(setup, EXAMPLES.resolve("my_follower.py"), errors);
        assertEquals(List.of(), errors);
        return result;
    }

    /** Runs a program as the controller of a run, and keeps what it writes to standard error. */
    private static RunResult run(SimulationSetup setup, Path program, List<String> errors) throws IOException {
        RunDescription run = RunDescription.of("faultline test", "Yard", setup, 1);
        try (ExternalController child = new ExternalController(
                "python3 " + program, run, ExternalController.Timeouts.DEFAULT, false, errors::add)) {
            return HeadlessRun.run(setup, child, ControllerMode.DIRECT, List.of());
        }
    }

    @Test
    void theClientLeavesTimeForFifteenThousandTicksASecond(@TempDir Path folder) throws Exception {
        Files.copy(EXAMPLES.resolve("faultline.py"), folder.resolve("faultline.py"));
        Path program = folder.resolve("timed.py");
        Files.writeString(
                program,
                """
                import sys, time
                import faultline
                begin, ticks = time.process_time(), 0
                def decide(sight):
                    global ticks
                    ticks += 1
                    return faultline.velocities(0.1, sight.distance("left", otherwise=0.5) - 0.25, state="FOLLOW")
                faultline.drive_with(decide)
                print((time.process_time() - begin) / ticks, file=sys.stderr)
                """);
        List<String> errors = new CopyOnWriteArrayList<>();
        run(Scenario.load(Path.of("scenarios/yard.xml")).setup(), program, errors);
        double secondsPerTick = Double.parseDouble(errors.get(0));
        assertTrue(secondsPerTick < 1 / 15_000.0, () -> secondsPerTick + " s of processor time a tick");
    }

    @Test
    void aFollowerThatForgetsToReturnItsDecisionIsToldSo(@TempDir Path folder) throws Exception {
        Files.copy(EXAMPLES.resolve("faultline.py"), folder.resolve("faultline.py"));
        Path program = Files.writeString(
                folder.resolve("forgets.py"),
                "import faultline\nfaultline.drive_with(lambda sight: print(sight['left']))\n");
        SimulationSetup setup = Scenario.load(Path.of("scenarios/yard.xml")).setup();
        RunFailedException e =
                assertThrows(RunFailedException.class, () -> run(setup, program, new CopyOnWriteArrayList<>()));
        assertTrue(
                e.getMessage()
                        .contains("; its last line on standard error: TypeError: decide returned None; it must return"
                                + " faultline.velocities(...) or faultline.volts(...) (forgets.py, line 2);"),
                e.getMessage());
        assertFalse(e.getMessage().contains("^^"), e.getMessage());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            faultline.velocities(float('nan'), 0) | ValueError: a drive needs finite numbers, not nan
            faultline.volts(0, float('inf'))      | ValueError: a drive needs finite numbers, not inf
            input()                               | EOFError: EOF when reading a line
            exec("raise ValueError('a\\\\nb')")    | b, after the exception ValueError: a
            """)
    void aMistakeOfAFollowerIsToldWithItsLine(String expression, String error, @TempDir Path folder) throws Exception {
        Files.copy(EXAMPLES.resolve("faultline.py"), folder.resolve("faultline.py"));
        Path program = Files.writeString(
                folder.resolve("mistaken.py"),
                "import faultline\ndef decide(sight):\n    return " + expression + "\nfaultline.drive_with(decide)\n");
        SimulationSetup setup = Scenario.load(Path.of("scenarios/yard.xml")).setup();
        RunFailedException e =
                assertThrows(RunFailedException.class, () -> run(setup, program, new CopyOnWriteArrayList<>()));
        assertTrue(
                e.getMessage().contains("; its last line on standard error: " + error + " (mistaken.py, line 3);"),
                e.getMessage());
        assertTrue(e.getMessage().contains("line 3, in decide"), e.getMessage());
    }

    @Test
    void theDocumentedExampleIsTheShippedOne() throws IOException {
        String page = Files.readString(Path.of("docs/controllers.md"));
        Matcher block = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL).matcher(page);
        assertTrue(block.find());
        String shipped = Files.readString(EXAMPLES.resolve("my_follower.py"));
        assertEquals(shipped.substring(shipped.indexOf("import")), block.group(1));
    }

    @Test
    void aRunIsSteppedFromPython() throws Exception {
        Output output = python(
                "-c",
                """
                import faultline
                with faultline.Simulator("scenarios/office.xml") as simulator:
                    hashes = []
                    for seed in (7, 7, 8):
                        sight = simulator.reset(seed=seed)
                        while not simulator.done:
                            sight = simulator.step(faultline.velocities(0.2, 0.3), ticks=500)
                        hashes.append(simulator.end["trajectory_hash"])
                    assert len(sight) == 8 and hashes[0] == hashes[1], hashes
                print("stepped")
                """);
        assertEquals("stepped", output.text().strip());
    }

    /** The simulator sends the robot again only if it differs from the one that it has sent last. */
    @Test
    void theRobotOfEveryRunIsThatOfTheSimulator(@TempDir Path folder) throws Exception {
        Path scenario = Files.writeString(
                folder.resolve("tuned.xml"),
                """
                <scenario xmlns="urn:faultline:scenario:1">
                  <world width="2" height="2"/>
                  <robot x="1" y="1" defaultSensors="false"><sensor id="eye" x="0.1" y="0" bearing="0"/></robot>
                  <timeline>
                    <tune at="0" sensor="eye" range="1.5"/>
                    <tune at="0.02" sensor="eye" range="1.6"/>
                  </timeline>
                </scenario>
                """);
        Output output = python(
                "-c",
                """
                import faultline, sys
                with faultline.Simulator(sys.argv[1]) as simulator:
                    for ticks in (1, 5, 1):
                        ranges = [simulator.reset(), simulator.step(faultline.volts(0, 0), ticks)]
                        print([sight.robot["sensors"][0]["range_m"] for sight in ranges])
                """,
                scenario.toString());
        assertEquals("[1.5, 1.5]\n[1.5, 1.6]\n[1.5, 1.5]", output.text().strip());
    }

    @Test
    void numbersOfOtherTypesAreSent() throws Exception {
        Output output = python(
                "-c",
                """
                import faultline, fractions
                class Int32:
                    def __index__(self): return 7
                half = fractions.Fraction(1, 2)
                with faultline.Simulator("scenarios/office.xml") as simulator:
                    simulator.reset(seed=Int32())
                    print(simulator.step(faultline.velocities(half, half), ticks=Int32()).tick)
                    print(simulator.step(faultline.volts(half, half)).tick)
                """);
        assertEquals("7\n8", output.text().strip());
    }

    @Test
    void mistakesAreExplained() throws Exception {
        Output output = python(
                "-c",
                """
                import faultline
                def explain(action):
                    try:
                        action()
                    except (KeyError, RuntimeError, FileNotFoundError) as mistake:
                        print(mistake.args[0])
                with faultline.Simulator("scenarios/office.xml") as simulator:
                    sight = simulator.reset()
                    explain(lambda: sight.distance("lefft", 1))
                    simulator.step(faultline.velocities(0, 0), ticks=1000000)
                    explain(lambda: simulator.step(faultline.velocities(0, 0)))
                    simulator.reset()
                explain(lambda: faultline.Simulator("scenarios/office.xml", command=["no-such-program"]))
                """);
        assertEquals(
                """
                there is no sensor 'lefft'; the robot has front, front-left, left, rear-left, rear, rear-right, right, \
                front-right
                the run is over (duration); reset begins another one
                there is no program 'no-such-program'; give the command that starts the simulator, or set FAULTLINE
                """,
                output.text());
    }

    @Test
    void aSimulatorThatHasEndedIsReported() throws Exception {
        Output output = python(
                "-X",
                "dev",
                "-c",
                """
                import faultline
                with faultline.Simulator("scenarios/office.xml") as simulator:
                    simulator.reset()
                    simulator._process.kill()
                    simulator._process.wait()
                    for action in (lambda: simulator.step(faultline.velocities(0, 0)), simulator.reset):
                        try:
                            action()
                        except RuntimeError as ended:
                            print(ended)
                """);
        assertEquals(
                """
                the simulator has ended with exit code -9; the reason is on its standard error
                the simulator is closed
                """,
                output.text());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "hello",
                "17",
                "[]",
                "{}",
                "{\"type\":\"observe\"}",
                "{\"type\":\"hello\"}",
                "{\"type\":\"hello\",\"robot\":{}}"
            })
    void aProgramThatIsNoSimulatorIsEnded(String line) throws Exception {
        Output output = python(
                "-X",
                "dev",
                "-c",
                """
                import faultline, subprocess, sys
                class Started(subprocess.Popen):
                    def __init__(self, *words, **options):
                        super().__init__(*words, **options)
                        Started.process = self
                subprocess.Popen = Started
                other = "import sys; print(sys.argv[1], flush=True); sys.stdin.read()"
                try:
                    faultline.Simulator("scenarios/office.xml", command=[sys.executable, "-c", other, sys.argv[1]])
                except RuntimeError as mistake:
                    print(mistake, Started.process.returncode)
                """,
                line);
        assertEquals("the first line is not the hello of the simulator: '" + line + "' -9\n", output.text());
    }

    @ParameterizedTest
    @ValueSource(strings = {"hello", "{}", "{\"type\":\"observe\"}"})
    void aFollowerWhoseInputIsNotFromASimulatorSaysSo(String line) throws Exception {
        Output output = python(
                "-c",
                """
                import io, sys
                import faultline
                given = sys.stdin = io.TextIOWrapper(io.BytesIO(sys.argv[1].encode()))
                try:
                    faultline.drive_with(lambda sight: faultline.velocities(0, 0))
                except RuntimeError as mistake:
                    print(mistake)
                """,
                line);
        assertEquals("the first line is not the hello of the simulator: '" + line + "'\n", output.text());
    }

    @Test
    void aFollowerTakesDeeplyNestedInputForNoHello() throws Exception {
        Output output = python(
                "-c",
                """
                import io, sys
                import faultline
                given = sys.stdin = io.TextIOWrapper(io.BytesIO(b"[" * 200_000))
                try:
                    faultline.drive_with(lambda sight: faultline.velocities(0, 0))
                except RuntimeError as mistake:
                    print(str(mistake)[:49])
                """);
        assertEquals("the first line is not the hello of the simulator:\n", output.text());
    }

    /** The answer to the step must not be taken for that to the reset. */
    @Test
    void anInterruptWhileASimulatorStepsClosesIt() throws Exception {
        Output output = python(
                "-X",
                "dev",
                "-c",
                """
                import faultline
                class Interrupted:
                    def __init__(self, stream): self.close = stream.close
                    def readline(self): raise KeyboardInterrupt
                simulator = faultline.Simulator("scenarios/office.xml")
                simulator.reset()
                answers = simulator._process.stdout
                simulator._process.stdout = Interrupted(answers)
                try:
                    simulator.step(faultline.velocities(0, 0), ticks=5)
                except KeyboardInterrupt:
                    simulator._process.stdout = answers
                try:
                    print(simulator.reset().tick)
                except RuntimeError as closed:
                    print(closed)
                simulator.close()
                """);
        assertEquals("the simulator is closed\n", output.text());
    }

    @Test
    void theGymnasiumEnvironmentPassesItsCheck() throws Exception {
        assumeTrue(python("-c", "import gymnasium").code() == 0, "needs the Python package gymnasium");
        Output output = python(
                "-W",
                "ignore",
                "-c",
                """
                from gymnasium.utils.env_checker import check_env
                import faultline_gym
                environment = faultline_gym.WallFollowingEnv()
                check_env(environment, skip_render_check=True)
                environment.close()
                print("checked")
                """);
        assertTrue(output.text().strip().endsWith("checked"), output.text());
        assertEquals(0, output.code());
    }

    @Test
    void aSimulatorThatIsNotClosedEndsWithItsObject() throws Exception {
        Output output = python(
                "-X",
                "dev",
                "-c",
                """
                import faultline, gc
                simulator = faultline.Simulator("scenarios/office.xml")
                process = simulator._process
                simulator.reset()
                print(process.poll())
                del simulator
                gc.collect()
                print(process.poll())
                """);
        assertEquals("None\n0\n", output.text());
    }

    @Test
    void copiesOfNoAnswerAreTheSameObject() throws Exception {
        Output output = python(
                "-c",
                """
                import copy, faultline, pickle
                sight = faultline.Sight(left=faultline.NO_ANSWER)
                print(copy.copy(sight["left"]) is faultline.NO_ANSWER)
                print(copy.deepcopy(sight)["left"] is faultline.NO_ANSWER)
                print(pickle.loads(pickle.dumps(sight["left"])) is faultline.NO_ANSWER)
                """);
        assertEquals("True\nTrue\nTrue\n", output.text());
    }

    @Test
    void theGymnasiumEnvironmentNeedsAResetFirstAndEndsWithItsObject() throws Exception {
        Output output = python(
                "-c",
                WITHOUT_PACKAGES
                        + """
                from types import SimpleNamespace
                sys.modules["gymnasium"].spaces = SimpleNamespace(Box=lambda *bounds: None)
                sys.modules["numpy"].float32 = float
                sys.modules["numpy"].clip = lambda action, least, most: action
                import faultline_gym, gc
                environment = faultline_gym.WallFollowingEnv()
                process = environment._simulator._process
                try:
                    environment.step([0.0, 0.0])
                except RuntimeError as e:
                    print(e)
                print(environment._simulator.reset().tick)
                environment._pose = {}
                sys.modules["numpy"].shape = lambda action: (len(action),)
                try:
                    environment.step([0.0, 0.0, 0.0])
                except ValueError as e:
                    print(e)
                del environment
                gc.collect()
                print(process.poll())
                """);
        assertEquals(
                """
                there is no episode, or it is over; reset begins one
                0
                the action has the shape (3,); expected (2,), for the left and the right side
                0
                """,
                output.text());
    }

    @Test
    void theGymnasiumEnvironmentNeedsAWantedDistance() throws Exception {
        Output output = python(
                "-c",
                WITHOUT_PACKAGES
                        + """
                import faultline_gym
                try:
                    faultline_gym.WallFollowingEnv(wanted_distance=0)
                except ValueError as e:
                    print(e)
                """);
        assertEquals("wanted_distance is 0; expected a number of metres above 0\n", output.text());
    }

    @Test
    void theGymnasiumEnvironmentRefusesARobotWithoutALeftSensor(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("eye.xml");
        Files.writeString(
                file,
                """
                <scenario xmlns="urn:faultline:scenario:1">
                  <world width="2" height="2"/>
                  <robot x="1" y="1" defaultSensors="false"><sensor id="eye" x="0.1" y="0" bearing="0"/></robot>
                </scenario>
                """);
        Output output = python(
                "-c",
                WITHOUT_PACKAGES
                        + """
                import faultline_gym
                try:
                    faultline_gym.WallFollowingEnv(sys.argv[1])
                except ValueError as e:
                    print(e)
                """,
                file.toString());
        assertEquals(
                "the reward needs a sensor \"left\"; the robot has eye",
                output.text().strip());
    }

    @Test
    void theDocumentedUseOfTheEnvironmentRuns() throws Exception {
        assumeTrue(python("-c", "import gymnasium").code() == 0, "needs the Python package gymnasium");
        Matcher block = Pattern.compile("```python\n(from faultline_gym .*?)```", Pattern.DOTALL)
                .matcher(Files.readString(Path.of("docs/controllers.md")));
        assertTrue(block.find());
        Output output = python(
                "-W",
                "ignore",
                "-c",
                block.group(1).replace("command=command", "command=None")
                        + "import gymnasium\n"
                        + "gymnasium.make('faultline/WallFollowing-v0').close()\n"
                        + "print(over)\n");
        assertEquals("True", output.text().strip());
    }

    /** REP 117 says what stands for a reading that is no distance. The modules of ROS 2 are replaced by empty ones. */
    @Test
    void theBridgeToRosWritesReadingsAsRanges() throws Exception {
        Output output = python(
                "-c",
                """
                import sys, types
                from types import SimpleNamespace
                for name in ("rclpy", "rclpy.node", "geometry_msgs", "geometry_msgs.msg", "sensor_msgs", "sensor_msgs.msg"):
                    sys.modules[name] = types.ModuleType(name)
                class Range:
                    INFRARED = 1
                    def __init__(self):
                        self.header = SimpleNamespace(stamp=SimpleNamespace())
                sys.modules["rclpy.node"].Node = sys.modules["geometry_msgs.msg"].Twist = object
                sys.modules["sensor_msgs.msg"].Range = Range
                import faultline, ros2_bridge
                print([ros2_bridge.to_topic(sensor) for sensor in ("front", "front-left", "2 eyes", "eye.1")])
                sensor = {"id": "left", "range_m": 0.8, "cone_rad": 0.35}
                for reading in (0.4, None, faultline.NO_ANSWER):
                    message = ros2_bridge.to_range(sensor, reading, 1.29)
                    print(message.range, message.max_range, message.header.stamp.sec, message.header.stamp.nanosec)
                """);
        assertEquals(
                "['range/front', 'range/front_left', 'range/_2_eyes', 'range/eye_1']\n"
                        + "0.4 0.8 1 290000000\ninf 0.8 1 290000000\nnan 0.8 1 290000000",
                output.text().strip());
    }

    @Test
    void theCommandInTheEnvironmentMayHavePathsWithBlanks() throws Exception {
        Output output = python(
                "-c",
                """
                import faultline, os
                os.environ["FAULTLINE"] = 'java -jar "/my robots/faultline.jar"'
                print(faultline.default_command())
                os.environ["FAULTLINE"] = 'java -jar "C:\\\\my robots\\\\faultline.jar"'
                os.name = "nt"
                print(faultline.default_command() == ["java", "-jar", "C:\\\\my robots\\\\faultline.jar"])
                """);
        assertEquals(
                "['java', '-jar', '/my robots/faultline.jar']\nTrue",
                output.text().strip());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "  "})
    void anEmptyCommandInTheEnvironmentIsNone(String empty) throws Exception {
        Output output = python(
                "-c",
                "import faultline, os, sys; os.environ['FAULTLINE'] = sys.argv[1]; print(faultline.default_command())",
                empty);
        assertEquals("['faultline']\n", output.text());
    }

    @Test
    void aCommandMayBeAText() throws Exception {
        Output output = python(
                "-c",
                """
                import faultline, os
                with faultline.Simulator("scenarios/office.xml", command=os.environ["FAULTLINE"]) as simulator:
                    print(simulator.reset().tick)
                try:
                    faultline.Simulator("scenarios/office.xml", command='"no such" program')
                except FileNotFoundError as mistake:
                    print(mistake)
                """);
        assertEquals(
                """
                0
                there is no program 'no such'; give the command that starts the simulator, or set FAULTLINE
                """,
                output.text());
    }

    private static Output python(String... arguments) throws IOException, InterruptedException {
        Map<String, String> environment = Map.of(
                "PYTHONPATH",
                EXAMPLES.toString(),
                "PYTHONDONTWRITEBYTECODE",
                "1",
                "FAULTLINE",
                String.join(" ", JavaProcess.program()));
        return PythonProcess.run(environment, arguments);
    }
}
