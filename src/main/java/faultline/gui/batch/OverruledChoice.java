package faultline.gui.batch;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.external.ControllerNames;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.world.Command;

/** Describes how the timeline of a scenario overrules what a batch chooses of the controller. */
final class OverruledChoice {

    private OverruledChoice() {}

    /**
     * Returns from when on the timeline of a plan's scenario overrules the diagnosis or the controller of the plan,
     * empty if it does not, given whether the controller is another one than that of the scenario.
     */
    static String describe(BatchPlan plan, boolean other) {
        if (!(plan.scenario().setup().controller() instanceof ControllerSpec.BuiltIn driving)) {
            // Other controllers refuse changes.
            return "";
        }
        for (TimedCommand timed : plan.scenario().setup().timeline()) {
            String key = timed.time() < plan.duration() && timed.command() instanceof Command.ConfigureController change
                    ? overruledKey(plan.diagnosis(), driving, change.controller(), other)
                    : "";
            if (!key.isEmpty()) {
                return Messages.get(key, NumberText.format("%.2f", timed.time()));
            }
        }
        return "";
    }

    private static String overruledKey(
            DiagnosisChoice diagnosis, ControllerSpec.BuiltIn driving, ControllerSpec.BuiltIn changed, boolean other) {
        boolean sameType = ControllerNames.typeOf(changed).equals(ControllerNames.typeOf(driving));
        if (!sameType) {
            return other || diagnosis != DiagnosisChoice.SCENARIO ? "batch.overruled.controller" : "";
        }
        return changed instanceof ControllerSpec.WallFollowing follower && diagnosis.differsFrom(follower.diagnosis())
                ? "batch.overruled.diagnosis"
                : "";
    }
}
