package faultline.gui.action;

import faultline.control.ControllerSpec;
import faultline.control.WallSide;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSink;
import faultline.gui.edit.SensorPresets;
import faultline.world.Command;
import java.util.List;

/** The actions that switch several sensors at once. */
public final class SensorActions {

    private static final int ALL_SENSORS = Integer.MAX_VALUE;

    private final Workspace workspace;
    private final RunController runController;
    private final CommandSink editor;

    public SensorActions(Workspace workspace, RunController run, CommandSink editor) {
        this.workspace = workspace;
        this.runController = run;
        this.editor = editor;
    }

    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of("sensorsTwo", () -> applyPreset(2)));
        actions.add(UiAction.of("sensorsThree", () -> applyPreset(3)));
        actions.add(UiAction.of("sensorsAll", () -> applyPreset(ALL_SENSORS)));
    }

    private void applyPreset(int count) {
        runController.frame().ifPresent(frame -> {
            List<Command> commands = SensorPresets.commands(frame.snapshot().robot(), isWallOnLeft(), count);
            if (!commands.isEmpty()) {
                editor.send(commands);
            }
        });
    }

    private boolean isWallOnLeft() {
        return workspace
                .scenario()
                .map(scenario -> scenario.setup().controller())
                .filter(controller ->
                        controller instanceof ControllerSpec.WallFollowing follow && follow.side() == WallSide.RIGHT)
                .isEmpty();
    }
}
