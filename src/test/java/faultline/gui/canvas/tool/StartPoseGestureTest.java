package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.SnapSettings;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;

/** Drags of the robot before its start; a room of 6 m by 4 m is 752 by 501 pixels. */
class StartPoseGestureTest {

    private static final Vector2 START = new Vector2(1, 1);
    private static final double PIXELS_PER_METRE = 752 / 6.0;

    private final Viewport viewport = new Viewport();
    private final CanvasListeners listeners = new CanvasListeners();
    private final List<Pose> requested = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();
    private Predicate<Snapshot> noteHolds;

    StartPoseGestureTest() {
        viewport.resize(800, 600);
        listeners.addStartListener(requested::add);
        listeners.addNoteListener((note, holds) -> {
            notes.add(note);
            noteHolds = holds;
        });
    }

    /** Drags the robot by its centre, to the right and upwards. */
    private void drag(boolean rotating, double right, double up) {
        Snapshot world = SampleFrames.frameOf(
                        new Pose(START.x(), START.y(), 0.5),
                        new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(4, 2, 0)))
                .snapshot();
        viewport.setWorld(world);
        Vector2 pressed = viewport.camera().get().toScreen(START);
        StartPoseGesture gesture = new StartPoseGesture(world, rotating, pressed, viewport, listeners);
        gesture.moveTo(pressed.plus(new Vector2(right, -up)), SnapSettings.NONE);
        gesture.release();
    }

    @Test
    void aMoveOfLessThanThreePixelsChangesNothing() {
        drag(false, 2, 0);
        assertEquals(List.of(), requested);
    }

    @Test
    void theStartMovesWithTheMouseAndKeepsItsHeading() {
        drag(false, 3, 0);
        assertEquals(START.x() + 3 / PIXELS_PER_METRE, requested.get(0).x(), 1e-4);
        assertEquals(START.y(), requested.get(0).y());
        assertEquals(0.5, requested.get(0).heading());
    }

    @Test
    void aRotationTurnsTheRobotToTheMouseInPlace() {
        drag(true, 0, 100);
        assertEquals(START, requested.get(0).position());
        assertEquals(Math.PI / 2, requested.get(0).heading(), 1e-9);
    }

    @Test
    void aStartOnAnObstacleIsRefusedWithItsName() {
        drag(false, 3 * PIXELS_PER_METRE, PIXELS_PER_METRE);
        assertEquals(List.of(), requested);
        assertEquals(1, notes.size());
        assertTrue(notes.get(0).contains("box"), notes.get(0));
        assertTrue(noteHolds.test(
                SampleFrames.frameOf(new Pose(START.x(), START.y(), 0.5)).snapshot()));
        assertFalse(noteHolds.test(SampleFrames.frameOf(new Pose(2, 1, 0.5)).snapshot()), "it starts elsewhere");
    }

    @Test
    void aStartOutsideTheRoomIsRefused() {
        drag(false, -200, 0);
        assertEquals(List.of(), requested);
        assertEquals(1, notes.size());
    }
}
