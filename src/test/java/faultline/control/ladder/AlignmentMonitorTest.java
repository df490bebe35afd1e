package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.Test;

class AlignmentMonitorTest {

    private final AlignmentMonitor monitor = new AlignmentMonitor();

    /** Returns the number of the first alignment that is reported as repeated, 0 if none is. */
    private int firstRepeated(int alignments, double spacing, double... turns) {
        double heading = 0;
        for (int i = 1; i <= alignments; i++) {
            heading += turns[i % turns.length];
            if (monitor.isRepeated(10 + spacing * i, heading)) {
                return i;
            }
        }
        return 0;
    }

    @Test
    void sixAlignmentsInOneDirectionWithinAMetreAreTooMany() {
        assertEquals(6, firstRepeated(20, 0.2, 0));
    }

    @Test
    void alignmentsFarApartAreNot() {
        // Five distances lie between six alignments: 1.1 m.
        assertEquals(0, firstRepeated(40, 0.2201, 0));
        monitor.reset();
        assertEquals(6, firstRepeated(40, 0.2199, 0));
    }

    @Test
    void alignmentsInOtherDirectionsAreThoseOfCorners() {
        assertEquals(0, firstRepeated(40, 0.1, 0.06));
        monitor.reset();
        assertEquals(6, firstRepeated(40, 0.1, 0.05));
        monitor.reset();
        assertEquals(0, firstRepeated(40, 0.1, -0.06));
    }

    @Test
    void twoOfTheDirectionsMustRepeat() {
        assertEquals(0, firstRepeated(40, 0.1, 1.5, 0, 1.5, 1.5, 1.5, 1.5, 1.5));
        monitor.reset();
        // The second and the fifth alignment repeat the one before.
        assertEquals(6, firstRepeated(7, 0.1, 1.5, 1.5, 0, 1.5, 1.5, 0, 1.5, 1.5));
        monitor.reset();
        // Only the first one repeats another, which was before these six.
        assertEquals(0, firstRepeated(6, 0.1, 1.5, 0, 0, 1.5, 1.5, 1.5, 1.5));
    }

    @Test
    void alignmentsBeforeAResetDoNotCount() {
        assertEquals(0, firstRepeated(5, 0.1, 0));
        monitor.reset();
        assertEquals(0, firstRepeated(5, 0.1, 0));
        assertFalse(monitor.isRepeated(12, 0));
    }
}
