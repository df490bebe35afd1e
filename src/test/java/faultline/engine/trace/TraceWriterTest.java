package faultline.engine.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.metrics.HeadlessRun;
import faultline.geometry.Angles;
import faultline.scenario.Scenario;
import faultline.sensor.Reading;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** The rows of a trace are those that plain code with the JDK's formatter writes. */
class TraceWriterTest {

    private static String plainRow(Simulation simulation) {
        List<String> cells = new ArrayList<>(List.of(Long.toString(simulation.ticks())));
        for (double number : new double[] {
            simulation.time(),
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
        for (int i = 0; i < simulation.robot().sensors().size(); i++) {
            cells.add(plainReading(simulation.trueReading(i)));
            cells.add(plainReading(simulation.reportedReading(i)));
        }
        return String.join(",", cells);
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

    @Test
    void stateNamesOfAControllerOutsideAreQuotedCells() throws Exception {
        List<String> states = List.of("a,b", "say \"x\"", "=1+1", "two\nlines", "PLAIN");
        Controller controller = observation -> new Decision(
                1, 1, Telemetry.ofState(ControllerState.of(states.get((int) observation.tick() / 10 % states.size()))));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (TraceWriter trace = new TraceWriter(out, TraceFormat.ONE)) {
            HeadlessRun.run(
                    Scenario.load(Path.of("scenarios/office.xml")).setup().withDuration(0.5),
                    controller,
                    ControllerMode.DIRECT,
                    List.of(trace));
            trace.flush();
        }
        List<String> rows = rows(out);
        assertEquals(52, rows.size());
        List<String> cells = new ArrayList<>();
        for (int tick = 5; tick < 50; tick += 10) {
            String row = rows.get(tick + 1);
            cells.add(row.replaceFirst("^([^,]*,){9}", "").replaceFirst(",false,.*", ""));
        }
        assertEquals(List.of("\"a,b\"", "\"say \"\"x\"\"\"", "'=1+1", "\"two lines\"", "PLAIN"), cells);
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
}
