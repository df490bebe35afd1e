package faultline.gui.window;

import faultline.control.ControllerSpec;
import faultline.control.Hand;
import faultline.gui.action.UiAction;
import faultline.gui.document.Bench;
import faultline.gui.document.RunDesk;
import faultline.gui.edit.Editor;
import faultline.gui.edit.SensorPresets;
import faultline.world.Command;
import java.util.List;

/** The actions that switch several sensors at once. */
final class SensorActions {

    private static final int ALL = Integer.MAX_VALUE;

    private final Bench bench;
    private final RunDesk run;
    private final Editor editor;

    SensorActions(Bench bench, RunDesk run, Editor editor) {
        this.bench = bench;
        this.run = run;
        this.editor = editor;
    }

    void addTo(UiActions actions) {
        actions.add(UiAction.of("sensorsTwo", () -> preset(2)));
        actions.add(UiAction.of("sensorsThree", () -> preset(3)));
        actions.add(UiAction.of("sensorsAll", () -> preset(ALL)));
    }

    private void preset(int count) {
        run.frame().ifPresent(frame -> {
            List<Command> commands = SensorPresets.commands(frame.world().robot(), isWallOnLeft(), count);
            if (!commands.isEmpty()) {
                editor.send(commands);
            }
        });
    }

    private boolean isWallOnLeft() {
        return bench.scenario().map(scenario -> scenario.setup().controller())
                .filter(controller -> controller instanceof ControllerSpec.WallFollowing follow && follow.hand() == Hand.RIGHT).isEmpty();
    }
}
