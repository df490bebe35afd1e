package faultline.gui.panel;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.gui.ComponentFinder;
import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
            return ComponentFinder.find(rows, JLabel.class, "front: Since");
        });
        assertEquals(expected, callOnEdt(since::getText));
        int width = callOnEdt(() -> since.getFontMetrics(since.getFont()).stringWidth(expected));
        assertTrue(width <= callOnEdt(since::getPreferredSize).width, "it is cut off");
    }
}
