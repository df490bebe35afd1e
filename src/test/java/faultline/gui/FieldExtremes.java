package faultline.gui;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertFalse;

import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.Expectation;
import faultline.gui.form.NumberSpinner;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.Container;
import java.util.List;
import javax.swing.SpinnerNumberModel;

/** Enters the least and the greatest number into every field of a panel. */
public final class FieldExtremes {

    private FieldExtremes() {}

    /** Enters the numbers, and calls a check after each. */
    public static void enterAll(Container panel, Runnable check) {
        List<NumberSpinner> fields = callOnEdt(() -> ComponentFinder.findAll(panel, NumberSpinner.class)
                .filter(NumberSpinner::isEnabled)
                .toList());
        assertFalse(fields.isEmpty());
        for (NumberSpinner field : fields) {
            SpinnerNumberModel model = (SpinnerNumberModel) field.getModel();
            for (Object extreme : List.of(model.getMinimum(), model.getMaximum())) {
                runOnEdt(() -> field.setValue(extreme));
                check.run();
            }
        }
    }

    /** Removes commands from a list, and checks that a scenario with each of them on its timeline can be saved. */
    public static void save(SimulationSetup setup, List<Command> commands) {
        List<Command> sent = callOnEdt(() -> List.copyOf(commands));
        runOnEdt(commands::clear);
        for (Command command : sent) {
            SimulationSetup changed = setup.withTimeline(List.of(new TimedCommand(1, command)));
            Scenario scenario = new Scenario("extremes", "", false, changed, Expectation.NONE);
            assertDoesNotThrow(scenario::toBytes, command.toString());
        }
    }
}
