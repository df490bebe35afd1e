package faultline.gui.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.SampleFrames;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.edit.Snap;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import java.util.List;
import org.junit.jupiter.api.Test;

class DragTest {

    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.Rectangle(1, 1), new Pose(2, 1, Degrees.toRadians(170)));

    private static Obstacle only(Wish wish) {
        assertEquals(1, wish.there().size());
        return wish.there().get(0);
    }

    @Test
    void aMoveKeepsTheGripUnderTheMouseAndTheHeading() {
        Wish wish = new Drag.Move(BOX, List.of(BOX), new Vec(2.25, 1.25)).wanted(new Vec(3.25, 0.75), Snap.NONE);
        Pose wanted = new Pose(3, 0.5, BOX.pose().heading());
        assertEquals(wanted, only(wish).pose());
        assertEquals(List.of(new Command.MoveObstacle("box", wanted)), wish.commands());
        assertEquals("x 3.000 m   y 0.500 m", wish.values());
    }

    @Test
    void whatIsSelectedMovesTogetherAndOnlyWhatIsHeldSnaps() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(1.03, 1, 0));
        Wish wish = new Drag.Move(BOX, List.of(pole, BOX), new Vec(2, 1)).wanted(new Vec(2.11, 1.02), new Snap(0.1, 0));
        assertEquals(0, wish.there().get(0).pose().position().distanceTo(new Vec(1.13, 1)), 1e-12);
        assertEquals(new Vec(2.1, 1), wish.there().get(1).pose().position());
    }

    @Test
    void aTurnFollowsTheMouseRoundTheMiddleAndIsNamedWithinHalfATurn() {
        Wish wish = new Drag.Turn(List.of(BOX), new Vec(3, 1)).wanted(new Vec(2, 4), Snap.NONE);
        assertEquals(Degrees.toRadians(260), only(wish).pose().heading(), 1e-12);
        assertEquals("heading -100.0\u00b0", wish.values());
    }

    @Test
    void aTurnSnapsToWholeSteps() {
        Wish wish = new Drag.Turn(List.of(BOX), new Vec(3, 1)).wanted(new Vec(2, 4), new Snap(0, Degrees.toRadians(45)));
        assertEquals(Degrees.toRadians(270), only(wish).pose().heading(), 1e-8);
    }

    @Test
    void severalTurnAboutTheirCommonMiddle() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(4, 1, 0));
        Drag turn = new Drag.Turn(List.of(BOX, pole), new Vec(4, 1));
        Wish wish = turn.wanted(new Vec(3.05, 2), new Snap(0, Degrees.toRadians(15)));
        assertEquals(0, wish.there().get(0).pose().position().distanceTo(new Vec(3, 0)), 1e-8);
        assertEquals(0, wish.there().get(1).pose().position().distanceTo(new Vec(3, 2)), 1e-8);
        assertEquals(Degrees.toRadians(260), wish.there().get(0).pose().heading(), 1e-8);
        assertEquals("turned by 90.0\u00b0", wish.values());
        assertEquals(List.of(new Command.MoveObstacle("box", BOX.pose()), new Command.MoveObstacle("pole", pole.pose())), turn.back());
    }

    @Test
    void aSideOfARectangleIsDraggedWhileTheOppositeOneStays() {
        Obstacle box = BOX.at(new Pose(2, 1, 0));
        // Handle 7 is the middle of the right side.
        Wish wish = new Drag.Resize(box, 7).wanted(new Vec(3.5, 9), Snap.NONE);
        assertEquals(new ObstacleShape.Rectangle(2, 1), only(wish).shape());
        assertEquals(new Pose(2.5, 1, 0), only(wish).pose());
        assertEquals("width 2.000 m   height 1.000 m", wish.values());
        assertEquals(List.of(new Command.PutObstacle(box)), new Drag.Resize(box, 7).back());
    }

    @Test
    void theRimOfAConeSetsItsRangeAndAnEdgeItsAngle() {
        SensorSpec spec = RobotSpec.DEFAULT.sensors().get(0);
        SensorSnapshot sensor = SampleFrames.sensor(spec, new Pose(1, 1, 0), SampleFrames.NOTHING);
        Vec apex = sensor.sector().apex();
        Wish rim = new Drag.Rim(spec, () -> sensor).wanted(apex.plus(new Vec(0.6, 0)), Snap.NONE);
        assertEquals(List.of(new Command.TuneSensor(spec.withRange(0.6))), rim.commands());
        Wish edge = new Drag.Edge(spec, () -> sensor).wanted(apex.plus(new Vec(0.5, 0.5)), Snap.NONE);
        assertEquals(List.of(new Command.TuneSensor(spec.withCone(Degrees.toRadians(90)))), edge.commands());
        assertEquals("cone 90.0\u00b0", edge.values());
    }
}
