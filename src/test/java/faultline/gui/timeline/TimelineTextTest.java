package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.world.Command;
import org.junit.jupiter.api.Test;

class TimelineTextTest {

    private static String titleOfMove(String obstacle) {
        return TimelineText.dialogTitle(
                new TimelineItem(new Command.MoveObstacle(obstacle, new Pose(1, 2, 0.5)), 3, 3));
    }

    @Test
    void timesThatDifferByATickDiffer() {
        TimelineItem item =
                TimelineItem.from(new Command.SwitchSensor("left", false), 0).withTimes(20.001, 20.004);
        assertEquals("20.001 – 20.004 s", TimelineText.times(item, 0.001));
        assertTrue(TimelineText.description(item, 0.0005).endsWith(", 20.0010 – 20.0040 s"));
    }

    @Test
    void theTitleOfAMoveIsNotAsLongAsTheIdOfTheObstacle() {
        assertEquals("chair moved", titleOfMove("chair"));
        String title = titleOfMove("chair-".repeat(16));
        assertTrue(title.startsWith("chair-chair-") && title.endsWith("... moved"), title);
        assertTrue(title.length() < 70, title);
    }
}
