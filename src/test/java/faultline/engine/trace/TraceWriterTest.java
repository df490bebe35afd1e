package faultline.engine.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.SensorHealth;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.robot.MotorSide;
import faultline.scenario.Scenario;
import faultline.sensor.Reading;
import faultline.world.WorldSpec;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The rows of a trace are those that plain code with the JDK's formatter writes. */
class TraceWriterTest {

    private static String plainRow(Simulation simulation) {
        List<String> cells = plainMotion(simulation, simulation.time());
        for (int i = 0; i < simulation.robot().sensors().size(); i++) {
            cells.add(plainReading(simulation.trueReading(i)));
            cells.add(plainReading(simulation.reportedReading(i)));
        }
        return String.join(",", cells);
    }

    private static List<String> plainMotion(Simulation simulation, double time) {
        List<String> cells = new ArrayList<>(List.of(Long.toString(simulation.ticks())));
        for (double number : new double[] {
            time,
            simulation.pose().x(),
            simulation.pose().y(),
            StrictMath.toDegrees(Angles.normalize(simulation.pose().heading())),
            simulation.velocity().linear(),
            simulation.velocity().angular(),
            simulation.wheelSpeeds().left(),
            simulation.wheelSpeeds().right()
        }) {
            cells.add(Double.toString(number));
        }
        cells.add(simulation.telemetry().state().name());
        cells.add(Boolean.toString(simulation.collision().isPresent()));
        return cells;
    }

    private static String plainRowOfFormatTwo(Simulation simulation) {
        BigDecimal dt = BigDecimal.valueOf(simulation.setup().dt());
        List<String> cells = plainMotion(
                simulation, dt.multiply(BigDecimal.valueOf(simulation.ticks())).doubleValue());
        Telemetry telemetry = simulation.telemetry();
        for (double number : new double[] {
            simulation.leftVolts(),
            simulation.rightVolts(),
            telemetry.wall().wantedDistance(),
            telemetry.wall().measuredDistance(),
            telemetry.wall().proportional(),
            telemetry.wall().derivative(),
            telemetry.edges().tF3(),
            telemetry.edges().tF4(),
            telemetry.edges().tP()
        }) {
            cells.add(plainNumber(number));
        }
        cells.add(telemetry.diagnosis().rung());
        for (MotorSide side : MotorSide.values()) {
            cells.add(plainFaults(simulation.motorFaults().of(side)));
        }
        for (int i = 0; i < simulation.robot().sensors().size(); i++) {
            cells.add(plainNumber(simulation.trueReading(i)));
            cells.add(plainNumber(simulation.reportedReading(i)));
            cells.add(Reading.isOff(simulation.reportedReading(i)) ? "0" : "1");
            cells.add(plainFaults(simulation.faults(i)));
            List<SensorHealth> health = telemetry.diagnosis().health();
            cells.add(health.isEmpty() ? "" : health.get(i).trust().name().toLowerCase(Locale.ROOT));
            cells.add(health.isEmpty() ? "" : health.get(i).finding().name().toLowerCase(Locale.ROOT));
            cells.add(health.isEmpty() ? "" : Double.toString(health.get(i).evidence()));
        }
        return String.join(",", cells);
    }

    private static String plainNumber(double number) {
        return Double.isFinite(number) ? Double.toString(number) : "";
    }

    /** Returns the faults as they are listed in the scenario, without a value if their kind has none. */
    private static String plainFaults(List<?> faults) {
        return faults.stream()
                .map(fault -> Map.of(
                                "Stuck[value=0.3]", "stuck=0.3",
                                "Dead[]", "off",
                                "Weak[value=0.9]", "weak=0.9",
                                "NoDrive[]", "dead")
                        .getOrDefault(fault.toString(), fault.toString()))
                .collect(Collectors.joining(" "));
    }

    private static String plainReading(double reading) {
        return Reading.isOff(reading) ? "off" : reading == Reading.NOTHING ? "" : Double.toString(reading);
    }

    private static List<String> rows(ByteArrayOutputStream out) {
        return out.toString(StandardCharsets.UTF_8).lines().toList();
    }

    private static void assertPlain(String scenario, double duration) throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<String> plain = new ArrayList<>();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE)) {
            HeadlessRun.run(
                    Scenario.load(Path.of("scenarios", scenario)).setup().withDuration(duration),
                    ControllerMode.DIRECT,
                    List.of(trace, simulation -> plain.add(plainRow(simulation))));
            trace.flush();
        }
        List<String> rows = rows(out);
        assertTrue(rows.get(0).startsWith("tick,t,x,y,heading_deg,v,omega,left_v,right_v,state,collided,"));
        assertEquals(plain, rows.subList(1, rows.size()));
    }

    @Test
    void rowsOfALongRunAreThoseOfPlainCode() throws Exception {
        assertPlain("three-visitors.xml", 60);
    }

    @Test
    void rowsWithNoiseAndWithSensorsThatAreOffAreThoseOfPlainCode() throws Exception {
        assertPlain("noisy-sensors.xml", 50);
        assertPlain("front-sensor-dies.xml", 100);
        assertPlain("collision-on-purpose.xml", 20);
    }

    /**
     * Returns a scenario in which faults come and go, with the eight usual sensors and others. With fifteen sensors, a
     * row has 128 cells, which fill two words of 64 bits.
     */
    private static Scenario withSensors(Path folder, int sensors) throws Exception {
        StringBuilder text = new StringBuilder("<scenario xmlns='urn:faultline:scenario:1' name='Traced' duration='12'>"
                + "<world width='5' height='4'/><robot x='2' y='0.7' heading='-90'>");
        for (int i = 8; i < sensors; i++) {
            text.append("<sensor id='s")
                    .append(i)
                    .append("' x='0' y='0' bearing='")
                    .append(20 * i - 180)
                    .append("'/>");
        }
        text.append("</robot>")
                .append(
                        """
                <timeline>
                  <fault at="0.5" sensor="right" kind="stuck" value="0.3" until="2"/>
                  <fault at="1" sensor="right" kind="off" until="3"/>
                  <fault at="8" sensor="front" kind="off"/>
                  <fault at="9" motor="left" kind="weak" value="0.9"/>
                  <fault at="10" motor="left" kind="dead"/>
                  <fault at="11" motor="right" kind="dead"/>
                </timeline></scenario>""");
        return Scenario.load(Files.writeString(folder.resolve("traced.xml"), text));
    }

    @ParameterizedTest
    @CsvSource({"8, 2147483647", "8, 1", "8, 7", "15, 2147483647", "15, 1"})
    void rowsOfFormatTwoAreThoseOfPlainCode(int sensors, int maxRows, @TempDir Path folder) throws Exception {
        SimulationSetup setup = withSensors(folder, sensors).setup();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<String> plain = new ArrayList<>();
        try (TraceWriter trace = new TraceWriter(new BufferedOutputStream(out), TraceFormat.TWO, maxRows)) {
            HeadlessRun.run(
                    setup,
                    ControllerMode.DIRECT,
                    List.of(trace, simulation -> plain.add(plainRowOfFormatTwo(simulation))));
            trace.flush();
        }
        plain.add(0, String.join(",", columns(TraceFormat.TWO, setup)));
        assertRows(plain, rows(out));
        assertEquals(23 + 7 * sensors, columns(TraceFormat.TWO, setup).size());
        assertTrue(plain.stream().anyMatch(row -> row.contains(",weak=0.9 dead,dead,")));
        assertTrue(plain.stream().anyMatch(row -> row.contains(",stuck=0.3 off,")));
    }

    @Test
    void aSensorThatIsSwitchedOffAndOnWithoutADiagnosisIsInItsColumn(@TempDir Path folder) throws Exception {
        Scenario scenario = Scenario.load(
                Files.writeString(
                        folder.resolve("switched.xml"),
                        """
                <scenario xmlns='urn:faultline:scenario:1' duration='0.4'><world width='5' height='4'/>
                  <robot x='2' y='2'/><controller type='wall-follower' diagnosis='off'/>
                  <timeline><switch at='0.1' sensor='right' on='false'/><switch at='0.2' sensor='right' on='true'/>
                  </timeline></scenario>"""));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.TWO)) {
            HeadlessRun.run(scenario.setup(), ControllerMode.DIRECT, List.of(trace));
            trace.flush();
        }
        int column = columns(TraceFormat.TWO, scenario.setup()).indexOf("right.answers");
        assertEquals(
                "1".repeat(10) + "0".repeat(10) + "1".repeat(21),
                rows(out).stream()
                        .skip(1)
                        .map(row -> row.split(",", -1)[column])
                        .collect(Collectors.joining()));
    }

    private static void assertRows(List<String> expected, List<String> actual) {
        for (int row = 0; row < Math.min(expected.size(), actual.size()); row++) {
            assertEquals(expected.get(row), actual.get(row));
        }
        assertEquals(expected.size(), actual.size());
    }

    private static List<String> columns(TraceFormat format, SimulationSetup setup) {
        return format.columns(setup.robot()).stream().map(TraceColumn::name).toList();
    }

    @Test
    void cellsOfADiagnosisAreEmptyWhileThereIsNone(@TempDir Path folder) throws Exception {
        SimulationSetup setup = withSensors(folder, 8).setup();
        List<SensorHealth> healths = setup.robot().sensors().stream()
                .map(sensor -> SensorHealth.trusted(sensor.id()))
                .toList();
        Controller controller = observation -> new Decision(
                1,
                1,
                new Telemetry(
                        ControllerState.of("s".repeat(5000)),
                        "",
                        0,
                        0,
                        Telemetry.WallControl.NONE,
                        Telemetry.EdgeTimes.NONE,
                        observation.tick() % 4 < 2
                                ? Telemetry.Diagnosis.NONE
                                : new Telemetry.Diagnosis("ALL", healths)));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        List<String> plain = new ArrayList<>();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.TWO)) {
            HeadlessRun.run(
                    setup.withDuration(0.3),
                    controller,
                    ControllerMode.DIRECT,
                    List.of(trace, simulation -> plain.add(plainRowOfFormatTwo(simulation))));
            trace.flush();
        }
        assertRows(plain, rows(out).subList(1, plain.size() + 1));
    }

    private static final List<String> UNUSUAL_NAMES = List.of("a,b", "say \"x\"", "=1+1", "two\nlines", "PLAIN");

    private static final List<String> CELLS_OF_UNUSUAL_NAMES =
            List.of("\"a,b\"", "\"say \"\"x\"\"\"", "'=1+1", "\"two lines\"", "PLAIN");

    /** Returns the rows of a run whose controller has other telemetry every ten ticks. */
    private static List<String> rowsOf(TraceFormat format, Function<String, Telemetry> telemetry) throws Exception {
        Controller controller = observation -> new Decision(
                1, 1, telemetry.apply(UNUSUAL_NAMES.get((int) observation.tick() / 10 % UNUSUAL_NAMES.size())));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (TraceWriter trace = new TraceWriter(out, format)) {
            HeadlessRun.run(
                    Scenario.load(Path.of("scenarios/office.xml")).setup().withDuration(0.5),
                    controller,
                    ControllerMode.DIRECT,
                    List.of(trace));
            trace.flush();
        }
        List<String> rows = rows(out);
        assertEquals(52, rows.size());
        return rows;
    }

    @Test
    void stateNamesOfAControllerOutsideAreQuotedCells() throws Exception {
        List<String> rows = rowsOf(TraceFormat.ONE, name -> Telemetry.ofState(ControllerState.of(name)));
        List<String> cells = new ArrayList<>();
        for (int tick = 5; tick < 50; tick += 10) {
            String row = rows.get(tick + 1);
            cells.add(row.replaceFirst("^([^,]*,){9}", "").replaceFirst(",false,.*", ""));
        }
        assertEquals(CELLS_OF_UNUSUAL_NAMES, cells);
    }

    @Test
    void namesOfRungsOfAControllerOutsideAreQuotedCells() throws Exception {
        Telemetry plain = Telemetry.ofState(FollowerState.FOLLOW);
        List<String> rows = rowsOf(
                TraceFormat.TWO,
                name -> new Telemetry(
                        plain.state(),
                        "",
                        0,
                        0,
                        plain.wall(),
                        plain.edges(),
                        new Telemetry.Diagnosis(name, List.of())));
        int before = List.of(rows.get(0).split(",")).indexOf("rung");
        for (int i = 0; i < UNUSUAL_NAMES.size(); i++) {
            String cells = rows.get(10 * i + 6).replaceFirst("^([^,]*,){" + before + "}", "");
            assertTrue(cells.startsWith(CELLS_OF_UNUSUAL_NAMES.get(i) + ","), cells);
        }
    }

    /** A stream that stops the writer until the run waits for it, and notes how far the run has come then. */
    private static final class SlowStream extends OutputStream {
        private final Thread run = Thread.currentThread();
        private final List<Long> ticks = new ArrayList<>();
        private final Set<Thread> writers = new LinkedHashSet<>();
        private long failAt = Long.MAX_VALUE;
        private volatile long tick;

        @Override
        public void write(int b) {
            throw new UnsupportedOperationException("a trace writes many bytes at a time");
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            writers.add(Thread.currentThread());
            while (Thread.currentThread() != run && run.getState() != Thread.State.WAITING) {
                Thread.onSpinWait();
            }
            ticks.add(tick);
            if (tick >= failAt) {
                throw new IOException("full at " + tick);
            }
        }

        private void makeRun(TraceWriter trace) throws Exception {
            HeadlessRun.run(
                    Scenario.load(Path.of("scenarios/yard.xml")).setup().withDuration(1),
                    ControllerMode.DIRECT,
                    List.of(simulation -> tick = simulation.ticks(), trace));
        }

        /** Asserts that there was a thread besides that of the run, and that it ends. */
        private void assertWriterEnds() throws InterruptedException {
            writers.remove(run);
            assertEquals(1, writers.size());
            for (Thread writer : writers) {
                assertTrue(writer.isDaemon(), "the program can end");
                writer.join(TimeUnit.MINUTES.toMillis(1));
                assertFalse(writer.isAlive());
            }
        }
    }

    @Test
    void aRunIsAtMostOneBlockAheadOfItsTrace() throws Exception {
        SlowStream out = new SlowStream();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.TWO, 20)) {
            out.makeRun(trace);
            trace.flush();
        }
        assertEquals(List.of(39L, 59L, 79L, 99L, 100L, 100L), out.ticks);
        out.assertWriterEnds();
    }

    @Test
    void aStreamThatFailsEndsTheRunAndTheThreadOfTheTrace() throws Exception {
        SlowStream out = new SlowStream();
        out.failAt = 59;
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE, 20)) {
            UncheckedIOException failed = assertThrows(UncheckedIOException.class, () -> out.makeRun(trace));
            assertEquals("full at 59", failed.getCause().getMessage());
        }
        assertEquals(List.of(39L, 59L), out.ticks, "nothing is written after a failure");
        out.assertWriterEnds();
    }

    @Test
    void aStreamThatFailsAtTheEndFailsTheLastFlush() throws Exception {
        SlowStream out = new SlowStream();
        out.failAt = 100;
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE, 20)) {
            out.makeRun(trace);
            assertEquals(
                    "full at 100", assertThrows(IOException.class, trace::flush).getMessage());
        }
        out.assertWriterEnds();
    }

    /** The last block is full at the last tick, so nothing is left to be written when the trace ends. */
    @Test
    void aStreamThatFailsInTheLastFullBlockFailsTheLastFlush() throws Exception {
        SlowStream out = new SlowStream();
        out.failAt = 100;
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE, 101)) {
            out.makeRun(trace);
            assertEquals(
                    "full at 100", assertThrows(IOException.class, trace::flush).getMessage());
        }
        out.assertWriterEnds();
    }

    private static final SimulationSetup ROOM = SimulationSetup.of(
                    new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0))
            .withDuration(0.02);

    @Test
    void aFlushWritesOnlyTheRowsSinceTheLastOne() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE);
                Simulation simulation = new Simulation(ROOM, ControllerMode.DIRECT)) {
            trace.flush();
            assertEquals(0, out.size());
            trace.observe(simulation);
            trace.flush();
            trace.flush();
            assertEquals(2, rows(out).size());
            simulation.tick();
            trace.observe(simulation);
            trace.flush();
        }
        List<String> rows = rows(out);
        assertEquals(3, rows.size());
        assertTrue(rows.get(1).startsWith("0,0"), rows.get(1));
        assertTrue(rows.get(2).startsWith("1,0.01,"), rows.get(2));
    }

    /** A controller that is not part of the program need not report all sensors. */
    @Test
    void theAssessmentOfASensorWithoutHealthIsEmpty() throws IOException {
        SensorHealth front = SensorHealth.trusted("front");
        Telemetry telemetry = new Telemetry(
                ControllerState.of("MINE"),
                "",
                0,
                0,
                Telemetry.WallControl.NONE,
                Telemetry.EdgeTimes.NONE,
                new Telemetry.Diagnosis("MINE", List.of(front)));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.TWO)) {
            HeadlessRun.run(ROOM, observation -> new Decision(0, 0, telemetry), ControllerMode.DIRECT, List.of(trace));
            trace.flush();
        }
        List<String> header = List.of(rows(out).get(0).split(","));
        List<String> last = List.of(rows(out).get(2).split(",", -1));
        assertEquals("trusted", last.get(header.indexOf("front.trust")));
        for (String column : List.of("trust", "finding", "evidence")) {
            assertEquals("", last.get(header.indexOf("front-right." + column)));
        }
    }
}
