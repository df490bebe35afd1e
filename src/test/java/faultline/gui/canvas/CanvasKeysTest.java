package faultline.gui.canvas;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.text.Texts;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import org.junit.jupiter.api.Test;

/** What the canvas does while the frames lag behind the commands, or never bring what was wanted. No display is needed. */
class CanvasKeysTest {

    private static final Pose ROBOT = new Pose(1, 1, 0);
    private static final Frame WITH_BOX =
            SampleFrames.of(ROBOT, new Obstacle("box", new ObstacleShape.Rectangle(0.8, 0.5), new Pose(4, 2, 0)));
    private static final Frame EMPTY = SampleFrames.of(ROBOT);

    private final List<Command> sent = new ArrayList<>();
    private final SimulationCanvas canvas = onEdt(() -> {
        SimulationCanvas made = new SimulationCanvas(sent::add);
        made.setSize(600, 440);
        made.show(WITH_BOX);
        made.tools().select(List.of("box"));
        return made;
    });

    @Test
    void nudgesBetweenTwoFramesAddUp() {
        key("RIGHT");
        key("RIGHT");
        assertEquals(List.of(moveTo(4.01), moveTo(4.02)), onEdt(() -> List.copyOf(sent)));
    }

    @Test
    void turningThereAndBackLeavesSeveralWhereTheyWere() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(5, 3, 0));
        edt(() -> canvas.show(SampleFrames.of(ROBOT, WITH_BOX.world().obstacles().get(0), pole)));
        edt(() -> canvas.tools().select(List.of("box", "pole")));
        for (String key : List.of("Q", "Q", "E", "E")) {
            key(key);
        }
        Command.MoveObstacle there = (Command.MoveObstacle) onEdt(() -> sent.get(3));
        Command.MoveObstacle back = (Command.MoveObstacle) onEdt(() -> sent.get(7));
        assertEquals("pole", back.obstacle());
        assertNotEquals(pole.pose().position(), there.pose().position());
        assertEquals(0, back.pose().position().distanceTo(pole.pose().position()), 1e-12);
    }

    @Test
    void afterARefusalTheNextNudgeStartsWhereTheObstacleReallyIs() {
        key("RIGHT");
        for (int frame = 0; frame < 20; frame++) {
            edt(() -> canvas.show(WITH_BOX));
        }
        key("RIGHT");
        assertEquals(List.of(moveTo(4.01), moveTo(4.01)), onEdt(() -> List.copyOf(sent)));
    }

    @Test
    void withoutASelectionNothingIsNudged() {
        key("ESCAPE");
        key("UP");
        assertEquals(List.of(), onEdt(() -> List.copyOf(sent)));
    }

    @Test
    void anObstacleThatIsGoneIsNoLongerSelected() {
        List<Set<String>> told = new ArrayList<>();
        edt(() -> canvas.tools().addSelectionListener(told::add));
        edt(() -> canvas.show(EMPTY));
        assertEquals(List.of(), onEdt(canvas.tools()::selected));
        assertEquals(List.of(Set.of()), onEdt(() -> List.copyOf(told)));
    }

    @Test
    void anObstacleThatVanishesFromTheHandIsLetGo() {
        Vec box = onEdt(() -> canvas.camera().toScreen(new Vec(4, 2)));
        mouse(MouseEvent.MOUSE_PRESSED, box);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vec(20, 0)));
        assertFalse(onEdt(sent::isEmpty), "the drag has begun");
        edt(sent::clear);
        edt(() -> canvas.show(EMPTY));
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vec(40, 0)));
        assertEquals(List.of(), onEdt(() -> List.copyOf(sent)));
    }

    @Test
    void whatIsNotThereCannotBeSelected() {
        edt(() -> canvas.tools().select(List.of("sofa")));
        assertEquals(List.of(), onEdt(canvas.tools()::selected));
    }

    @Test
    void aScreenReaderIsToldWhatItIs() {
        AccessibleContext context = onEdt(canvas::getAccessibleContext);
        assertEquals(Texts.text("canvas"), context.getAccessibleName());
        assertEquals(AccessibleRole.CANVAS, context.getAccessibleRole());
    }

    private static Command moveTo(double x) {
        return new Command.MoveObstacle("box", new Pose(x, 2, 0));
    }

    private void key(String key) {
        edt(() -> canvas.getActionMap().get(key).actionPerformed(new ActionEvent(canvas, ActionEvent.ACTION_PERFORMED, key)));
    }

    private void mouse(int type, Vec at) {
        edt(() -> canvas.dispatchEvent(new MouseEvent(canvas, type, 0, InputEvent.BUTTON1_DOWN_MASK, (int) at.x(), (int) at.y(), 1, false,
                MouseEvent.BUTTON1)));
    }
}
