package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.io.JsonWriter;
import faultline.io.ProgramVersion;
import faultline.scenario.Scenario;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

class ControllerSelectionTest {

    @Test
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
    void aChildIsGivenTheVersionOfTheProgramAndTheNameOfTheScenario() throws Exception {
        // The message of a child that ends too early repeats what it wrote to standard error.
        ControllerSelection echo = new ControllerSelection("sh -c 'read hello; echo \"$hello\" >&2'", List.of());
        SimulationSetup setup = echo.applyTo(Scenario.loadShipped("yard.xml").setup(), "Yard", line -> {});
        RunFailedException e =
                assertThrows(RunFailedException.class, () -> new Simulation(setup, ControllerMode.DIRECT));
        String version = JsonWriter.quoted(ProgramVersion.text());
        assertTrue(e.getMessage().contains("\"program\":" + version + ",\"scenario\":\"Yard\""), e.getMessage());
    }
}
