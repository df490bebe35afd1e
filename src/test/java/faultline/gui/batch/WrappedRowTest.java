package faultline.gui.batch;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.Component;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JRootPane;
import org.junit.jupiter.api.Test;

class WrappedRowTest {

    private static WrappedRow row(int windowWidth) {
        return callOnEdt(() -> {
            WrappedRow row = new WrappedRow();
            Stream.of("Start", "Save the plan as", "Save results", "Close")
                    .map(JButton::new)
                    .forEach(row::add);
            JRootPane root = new JRootPane();
            root.getContentPane().setLayout(new BorderLayout());
            root.getContentPane().add(row, BorderLayout.SOUTH);
            root.setSize(windowWidth, 300);
            root.doLayout();
            root.getLayeredPane().doLayout();
            root.getContentPane().doLayout();
            row.doLayout();
            return row;
        });
    }

    private static long rows(WrappedRow row) {
        return Stream.of(row.getComponents())
                .mapToInt(Component::getY)
                .distinct()
                .count();
    }

    @Test
    void allButtonsAreVisibleHoweverNarrowTheWindow() {
        for (int width : new int[] {180, 260, 400, 900}) {
            WrappedRow row = row(width);
            for (Component button : row.getComponents()) {
                assertTrue(
                        button.getX() >= 0
                                && button.getX() + button.getWidth() <= width
                                && button.getY() + button.getHeight() <= row.getHeight(),
                        width + ": " + button.getBounds() + " in " + row.getSize());
            }
        }
        assertEquals(1, rows(row(900)));
        assertTrue(rows(row(260)) > 1);
    }
}
