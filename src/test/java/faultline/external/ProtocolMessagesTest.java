package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.io.JsonWriter;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ProtocolMessagesTest {

    private static String truth(Simulation simulation) {
        JsonWriter json = new JsonWriter();
        ProtocolMessages.writeTruth(json, simulation);
        return json.finish();
    }

    /**
     * The pole is 3 m in front of the robot's centre at first, so the front sensor, which fails after 2 s, sees
     * nothing.
     */
    @Test
    void theTruthIsThePoseTheTrueReadingsAndTheCollision() throws ScenarioException {
        Simulation simulation =
                new Simulation(Scenario.loadShipped("collision-on-purpose.xml").setup(), ControllerMode.DIRECT);
        int front = simulation.robot().indexOf("front");
        assertEquals(
                "{\"truth\":{\"pose\":{\"x_m\":1,\"y_m\":2,\"heading_rad\":0},"
                        + "\"readings_m\":[null,null,null,null,null,null,null,null],\"collided\":false}}",
                truth(simulation));

        while (simulation.time() < 4 || simulation.trueReading(front) > 0.5) {
            simulation.tick();
        }
        assertTrue(Double.isNaN(simulation.reportedReading(front)));
        assertEquals(
                "{\"truth\":{\"pose\":{\"x_m\":" + simulation.pose().x() + ",\"y_m\":2,\"heading_rad\":0},"
                        + "\"readings_m\":[" + simulation.trueReading(front)
                        + ",null,null,null,null,null,null,null],\"collided\":false}}",
                truth(simulation));

        while (simulation.collision().isEmpty()) {
            simulation.tick();
        }
        assertTrue(truth(simulation).endsWith("],\"collided\":true}}"), truth(simulation));
        simulation.close();
    }

    @Test
    void theLastMessageSaysWhetherTheTruthWasGiven() {
        Map<String, String> summary = new LinkedHashMap<>();
        summary.put("state", "STOP");
        summary.put("laps", "2");
        assertEquals(
                "{\"type\":\"end\",\"reason\":\"duration\",\"trajectory_hash\":\"0f\","
                        + "\"summary\":{\"state\":\"STOP\",\"laps\":\"2\"}}",
                ProtocolMessages.end("duration", "0f", summary, false).finish());
        assertEquals(
                "{\"type\":\"end\",\"reason\":\"collision\",\"trajectory_hash\":\"0f\","
                        + "\"summary\":{\"truth\":\"given to the controller\",\"state\":\"STOP\",\"laps\":\"2\"}}",
                ProtocolMessages.end("collision", "0f", summary, true).finish());
    }
}
