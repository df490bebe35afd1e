package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.gui.edit.CommandSender;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;

class ToolContextTest {

    private final CanvasModel model = new CanvasModel();
    private final CanvasListeners listeners = new CanvasListeners();
    private final List<Command> sent = new ArrayList<>();
    private final List<Predicate<Snapshot>> refusals = new ArrayList<>();
    private final ToolContext context = new ToolContext(
            model, new Viewport(), new CommandSender((commands, onExecuted) -> sent.addAll(commands)), listeners);

    private static Obstacle box(double x) {
        return new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(x, 2, 0));
    }

    @Test
    void aRefusedPlaceIsNotedUntilTheRobotOrTheObstacleIsElsewhere() {
        listeners.addNoteListener((note, holds) -> refusals.add(holds));
        model.setFrame(SampleFrames.frameOf(new Pose(2, 2, 0)));
        assertFalse(context.placeObstacle(box(2)));
        assertEquals(List.of(), sent);
        Predicate<Snapshot> holds = refusals.get(0);
        assertTrue(holds.test(SampleFrames.frameOf(new Pose(2, 2, 0)).snapshot()));
        assertFalse(holds.test(SampleFrames.frameOf(new Pose(5, 2, 0)).snapshot()));
        assertFalse(holds.test(SampleFrames.frameOf(new Pose(2, 2, 0), box(4)).snapshot()));
    }
}
