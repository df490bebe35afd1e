package faultline.gui.batch;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.external.ControllerChoice;
import faultline.external.ControllerNames;
import faultline.gui.text.Messages;
import faultline.io.MessageText;
import java.util.ArrayList;
import java.util.List;

/**
 * An item of the list of controllers that can drive the robots of a batch: one that a scenario file names, as in a
 * campaign. A campaign starts no programs.
 *
 * @param origin where it comes from
 * @param choice its name, empty for that of the scenario, and the jars with it
 */
record BatchControllerItem(ControllerOrigin origin, ControllerChoice choice) {

    /** Where a controller comes from. */
    enum ControllerOrigin {
        /** The scenario names it. */
        SCENARIO,
        /** It has been chosen for the runs of the window. */
        CHOSEN,
        /** It is the one that scenarios have by default. */
        BUILT_IN
    }

    /**
     * Returns the items for a scenario, the preferred one first, given the controller that has been chosen in the
     * window and whether that starts a program.
     */
    static List<BatchControllerItem> items(SimulationSetup setup, ControllerChoice chosen, boolean program) {
        List<BatchControllerItem> items = new ArrayList<>();
        if (!chosen.isScenarioDefault() && !program && !isSame(chosen, setup)) {
            items.add(new BatchControllerItem(ControllerOrigin.CHOSEN, chosen));
        }
        // No plan can name a controller that the user has to choose.
        if (!(setup.controller() instanceof ControllerSpec.Extern)) {
            items.add(new BatchControllerItem(ControllerOrigin.SCENARIO, ControllerChoice.SCENARIO));
        }
        ControllerChoice follower = ControllerChoice.of(ControllerNames.WALL_FOLLOWER);
        if (!isSame(follower, setup) && !follower.text().equals(chosen.text())) {
            items.add(new BatchControllerItem(ControllerOrigin.BUILT_IN, follower));
        }
        return items;
    }

    /** Returns whether a built-in controller is that of the scenario. One from a jar may be another than there. */
    private static boolean isSame(ControllerChoice choice, SimulationSetup setup) {
        return choice.isBuiltIn() && choice.applyByName(setup).equals(setup);
    }

    /** Returns a setup whose runs are driven by it. */
    SimulationSetup applyTo(SimulationSetup setup) {
        return choice.applyByName(setup);
    }

    /** Returns its origin and its name, given the setup that it is applied to. */
    String text(SimulationSetup setup) {
        return Messages.get(
                "batch.controller." + origin,
                nameOf(ControllerNames.typeOf(applyTo(setup).controller())));
    }

    /** Returns the name of a type of controller: that of the program in words, another one as it is. */
    static String nameOf(String type) {
        String key = "batch.controller.type." + type;
        return Messages.contains(key) ? Messages.get(key) : MessageText.excerpt(type);
    }
}
