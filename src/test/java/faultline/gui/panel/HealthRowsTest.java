package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.form.NarrowingColumn;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

@ExtendWith(EdtChecker.class)
class HealthRowsTest {

    @ParameterizedTest
    @CsvSource({"0, 0.01 s", "999998, 9999.99 s", "999999, 10000 s", "1092440, 10924 s", "35999999, 360000 s"})
    void aTimeOfALongRunFits(long tick, String expected) {
        JLabel since = callOnEdt(() -> {
            HealthRows rows = new HealthRows();
            rows.setHealth(
                    List.of("front"),
                    List.of(new SensorHealth("front", SensorTrust.DISTRUSTED, SensorFinding.STUCK, 1, tick)),
                    0.01);
            return ComponentFinder.findValue(rows, "front: Since");
        });
        assertEquals(expected, callOnEdt(since::getText));
        int width = callOnEdt(() -> since.getFontMetrics(since.getFont()).stringWidth(expected));
        assertTrue(width <= callOnEdt(since::getPreferredSize).width, "it is cut off");
    }

    /** Where the row of a usual id has just enough room, that of a long one has too. */
    @ParameterizedTest
    @EnumSource(TextSize.class)
    void aLongIdIsShortenedInItsRow(TextSize size) {
        String longId = "a-very-long-sensor-id-".repeat(4);
        runOnEdt(() -> {
            size.install();
            Theme.LIGHT.install();
            int usual = rows("front-right").getPreferredSize().width;
            HealthRows rows = rows(longId);
            placeInTab(rows, usual);
            JLabel name = ComponentFinder.findAll(rows, JLabel.class)
                    .filter(label -> longId.equals(label.getText()))
                    .findFirst()
                    .orElseThrow();
            JLabel since = ComponentFinder.findValue(rows, longId + ": Since");
            assertEquals(name.getY(), since.getY(), "the row is wrapped");
            assertTrue(since.getX() + since.getWidth() <= rows.getWidth(), "the row is cut off");
            assertEquals(longId, name.getToolTipText());
        });
    }

    private static HealthRows rows(String id) {
        HealthRows rows = new HealthRows();
        rows.setHealth(List.of(id), List.of(), 0.01);
        return rows;
    }

    private static void placeInTab(HealthRows rows, int width) {
        NarrowingColumn column = new NarrowingColumn();
        column.add(rows);
        JScrollPane tab = new JScrollPane(column);
        tab.setBorder(null);
        tab.setSize(width, 400);
        ComponentFinder.layOut(tab);
    }
}
