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
        Path path = recorder.view();
        assertEquals(2, path.size());
        assertEquals(0.006, path.x(1));
    }

    @Test
    void aViewStaysAsItIsAndALaterOneContinuesIt() {
        drive(0, 100);
        Path early = recorder.view();
        drive(100, 10_000);
        Path late = recorder.view();
        assertEquals(100, early.size());
        assertEquals(10_000, late.size());
        assertTrue(late.continues(early));
        assertFalse(early.continues(late));
    }

    @Test
    void oneMorePointThanIsKeptThinsThemToEverySecond() {
        drive(0, PathRecorder.MOST);
        Path full = recorder.view();
        drive(PathRecorder.MOST, PathRecorder.MOST + 1);
        Path thinned = recorder.view();
        assertEquals(PathRecorder.MOST, full.size());
        assertEquals(PathRecorder.MOST / 2 + 1, thinned.size());
        assertFalse(thinned.continues(full));
        assertEquals(7 * STEP, full.x(7));
        assertEquals(14 * STEP, thinned.x(7));
        assertEquals(PathRecorder.MOST * STEP, thinned.x(thinned.size() - 1));
    }

    @Test
    void afterThinningTheSpacingIsTwiceAsWide() {
        drive(0, PathRecorder.MOST + 1);
        int before = recorder.view().size();
        drive(PathRecorder.MOST + 1, PathRecorder.MOST + 2);
        assertEquals(before, recorder.view().size());
        drive(PathRecorder.MOST + 2, PathRecorder.MOST + 3);
        assertEquals(before + 1, recorder.view().size());
    }

    @Test
    void aStretchIsLeftOutOnlyWhereItsBoxDoesNotTouchAndAllItsPointsAreThere() {
        drive(0, 100);
        Path path = recorder.view();
        Rectangle2D nearTheStart = new Rectangle2D.Double(0, 0.5, 0.05, 1);
        Rectangle2D above = new Rectangle2D.Double(0, 2, 1, 1);
        assertEquals(0, path.outside(0, nearTheStart));
        assertEquals(64, path.outside(0, above));
        assertEquals(0, path.outside(1, above), "not the start of a stretch");
        assertEquals(0, path.outside(64, above), "only 36 points of it are there");
    }
}
