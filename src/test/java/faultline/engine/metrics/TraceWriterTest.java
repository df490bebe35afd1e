package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.geometry.Angles;
import faultline.scenario.Scenario;
import faultline.sensor.Reading;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
        TraceWriter trace = new TraceWriter(out, TraceFormat.ONE);
        List<String> plain = new ArrayList<>();
        HeadlessRun.run(
                Scenario.load(Path.of("scenarios", scenario)).setup().withDuration(duration),
                ControllerMode.DIRECT,
                List.of(trace, simulation -> plain.add(plainRow(simulation))));
        trace.flush();
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
}
