package faultline.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

class EdtCheckerTest {

    @Test
    void aLabelChangedOnTheTestsOwnThreadIsFound() {
        EdtChecker checker = new EdtChecker();
        checker.beforeEach(null);
        JLabel label = GuiRobot.callOnEdt(() -> new JLabel("before"));
        assertEquals(List.of(), checker.violations());
        label.setText("after");
        assertThrows(AssertionError.class, () -> checker.afterEach(null));
    }
}
