package faultline.gui.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import org.junit.jupiter.api.Test;

class DragTest {

    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.Rectangle(1, 1), new Pose(2, 1, Degrees.toRadians(170)));

    @Test
    void aMoveKeepsTheGripUnderTheMouseAndTheHeading() {
        Drag move = new Drag.Move(BOX, new Vec(2.25, 1.25));
        Pose wanted = move.wanted(new Vec(3.25, 0.75));
        assertEquals(new Pose(3, 0.5, BOX.pose().heading()), wanted);
        assertEquals("x 3.000 m   y 0.500 m", move.values(wanted));
    }

    @Test
    void aTurnFollowsTheMouseRoundTheMiddleAndIsNamedWithinHalfATurn() {
        Drag turn = new Drag.Turn(BOX, new Vec(3, 1));
        Pose wanted = turn.wanted(new Vec(2, 4));
        assertEquals(Degrees.toRadians(260), wanted.heading(), 1e-12);
        assertEquals("heading -100.0\u00b0", turn.values(wanted));
    }
}
