package faultline.gui.instrument;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.EdtChecker;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import java.awt.Dimension;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@ExtendWith(EdtChecker.class)
class PositionedSplitPaneTest {

    private static final int RIGHT = 120;

    private PositionedSplitPane split;
    private JPanel right;

    @BeforeEach
    void build() {
        runOnEdt(() -> {
            right = new JPanel();
            JPanel left = new JPanel();
            left.setMinimumSize(new Dimension());
            right.setMinimumSize(new Dimension());
            split = new PositionedSplitPane("divider.chart", PositionedSplitPane.HORIZONTAL_SPLIT, left, right, 1);
            split.place(size -> size - RIGHT);
        });
    }

    private void lay(int width) {
        split.setSize(width, 100);
        split.doLayout();
    }

    @Test
    void theDividerHasANameForScreenReadersInTheLanguageOfTheWindow() {
        runOnEdt(() -> {
            assertEquals(
                    Messages.get("divider.chart"), split.getAccessibleContext().getAccessibleName());
            split.getAccessibleContext().setAccessibleName("");
            RefreshSteps.run(split);
            assertEquals(
                    Messages.get("divider.chart"), split.getAccessibleContext().getAccessibleName());
        });
    }

    @Test
    void aPlaceThatIsChosenBeforeThereIsASizeIsTakenAtTheFirstLayout() {
        runOnEdt(() -> {
            lay(600);
            assertEquals(RIGHT, right.getWidth());
        });
    }

    @Test
    void theDividerKeepsItsPlaceInPanesOfOtherSizes() {
        runOnEdt(() -> {
            for (int width : new int[] {600, 140, 601, 40, 900, 300}) {
                lay(width);
                assertEquals(Math.min(RIGHT, width - split.getDividerSize()), right.getWidth(), "in " + width);
            }
        });
    }

    @Test
    void aPaneThatHasANewSizeButIsNotLaidOutYetTakesItsDividerToTheRightPlace() {
        runOnEdt(() -> {
            lay(600);
            split.setSize(560, 100);
            split.place(size -> size - RIGHT);
            split.doLayout();
            assertEquals(RIGHT, right.getWidth());
            lay(580);
            assertEquals(RIGHT, right.getWidth());
        });
    }

    @Test
    void aDividerThatSomebodyHasMovedIsNotTakenBack() {
        runOnEdt(() -> {
            lay(600);
            split.setDividerLocation(200);
            lay(600);
            int chosen = right.getWidth();
            assertEquals(600 - 200 - split.getDividerSize(), chosen);
            lay(700);
            assertEquals(chosen, right.getWidth());
        });
    }

    @Test
    void anotherLookLeavesTheDividerWhereItIs() {
        runOnEdt(() -> {
            lay(600);
            split.updateUI();
            lay(600);
            assertEquals(RIGHT, right.getWidth());
        });
    }
}
