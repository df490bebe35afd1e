package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Rectangle2D;
import org.junit.jupiter.api.Test;

class PathRecorderTest {

    private static final double STEP = 0.006;
    private final PathRecorder recorder = new PathRecorder();

    /** Goes straight ahead; point i lies at i steps. */
    private void drive(int from, int to) {
        for (int i = from; i < to; i++) {
            recorder.record(i * STEP, 1);
        }
    }

    @Test
    void pointsNearerThanTheSpacingAreLeftOut() {
        recorder.record(0, 0);
        recorder.record(0.004, 0);
        recorder.record(0.006, 0);
        RobotPath path = recorder.view();
        assertEquals(2, path.size());
        assertEquals(0.006, path.x(1));
    }

    @Test
    void aViewStaysAsItIsAndALaterOneContinuesIt() {
        drive(0, 100);
        RobotPath early = recorder.view();
        drive(100, 10_000);
        RobotPath late = recorder.view();
        assertEquals(100, early.size());
        assertEquals(10_000, late.size());
        assertTrue(late.isContinuationOf(early));
        assertFalse(early.isContinuationOf(late));
    }

    @Test
    void oneMorePointThanIsKeptThinsThemToEverySecond() {
        drive(0, PathRecorder.MAX_POINTS);
        RobotPath full = recorder.view();
        drive(PathRecorder.MAX_POINTS, PathRecorder.MAX_POINTS + 1);
        RobotPath thinned = recorder.view();
        assertEquals(PathRecorder.MAX_POINTS, full.size());
        assertEquals(PathRecorder.MAX_POINTS / 2 + 1, thinned.size());
        assertFalse(thinned.isContinuationOf(full));
        assertEquals(7 * STEP, full.x(7));
        assertEquals(14 * STEP, thinned.x(7));
        assertEquals(PathRecorder.MAX_POINTS * STEP, thinned.x(thinned.size() - 1));
    }

    @Test
    void afterThinningTheSpacingIsTwiceAsWide() {
        drive(0, PathRecorder.MAX_POINTS + 1);
        int before = recorder.view().size();
        drive(PathRecorder.MAX_POINTS + 1, PathRecorder.MAX_POINTS + 2);
        assertEquals(before, recorder.view().size());
        drive(PathRecorder.MAX_POINTS + 2, PathRecorder.MAX_POINTS + 3);
        assertEquals(before + 1, recorder.view().size());
    }

    @Test
    void aBlockIsLeftOutOnlyWhereItsBoxDoesNotTouchAndAllItsPointsArePresent() {
        drive(0, 100);
        RobotPath path = recorder.view();
        Rectangle2D nearTheStart = new Rectangle2D.Double(0, 0.5, 0.05, 1);
        Rectangle2D above = new Rectangle2D.Double(0, 2, 1, 1);
        assertEquals(0, path.skippablePoints(0, nearTheStart));
        assertEquals(64, path.skippablePoints(0, above));
        assertEquals(0, path.skippablePoints(1, above), "not the start of a stretch");
        assertEquals(0, path.skippablePoints(64, above), "only 36 points of it are there");
    }
}
