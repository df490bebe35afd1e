package faultline.gui.instrument;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.EdtChecker;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.FocusEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.KeyStroke;
import javax.swing.plaf.basic.BasicSplitPaneUI;
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

    /** Keys move a divider that has the focus; the next one gets it from there. */
    @Test
    void escapeReturnsTheFocusFromDividersToWhereItWas() {
        List<JPanel> focused = new ArrayList<>();
        runOnEdt(() -> {
            JPanel before = new JPanel() {
                @Override
                public boolean requestFocusInWindow(FocusEvent.Cause cause) {
                    return focused.add(this);
                }
            };
            PositionedSplitPane outer =
                    new PositionedSplitPane("divider.chart", PositionedSplitPane.VERTICAL_SPLIT, split, before, 1);
            gainFocus(split, before);
            gainFocus(outer, split);
            gainFocus(outer, null);
            outer.getActionForKeyStroke(KeyStroke.getKeyStroke("ESCAPE")).actionPerformed(null);
            assertEquals(List.of(before), focused);
        });
    }

    private static void gainFocus(PositionedSplitPane pane, Component from) {
        FocusEvent event = new FocusEvent(pane, FocusEvent.FOCUS_GAINED, false, from);
        Stream.of(pane.getFocusListeners()).forEach(listener -> listener.focusGained(event));
    }

    @Test
    void aFocusedDividerHasTheAccentColour() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            AtomicBoolean focused = new AtomicBoolean();
            JSplitPane pane = new JSplitPane() {
                @Override
                public boolean isFocusOwner() {
                    return focused.get();
                }
            };
            Component divider = ((BasicSplitPaneUI) pane.getUI()).getDivider();
            divider.setSize(7, 50);
            assertEquals(Theme.LIGHT.colours().line().getRGB(), middle(divider));
            focused.set(true);
            assertEquals(Theme.LIGHT.colours().accent().getRGB(), middle(divider));
        });
    }

    /** Returns the colour in the middle of a divider. */
    private static int middle(Component divider) {
        BufferedImage image = new BufferedImage(7, 50, BufferedImage.TYPE_INT_RGB);
        divider.paint(image.createGraphics());
        return image.getRGB(3, 25);
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
