package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import javax.swing.JMenuItem;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ContextMenuTest {

    @ParameterizedTest
    @CsvSource({"1, 1", "9, 9", "10, A", "35, Z"})
    void anItemHasItsNumberOrALetterAsMnemonic(int number, char mark) {
        runOnEdt(() -> {
            JMenuItem item = new JMenuItem();
            ContextMenu.number(item, number, "left");
            assertEquals(mark + "  left", item.getText());
            assertEquals(mark, item.getMnemonic());
        });
    }

    /** A robot may have a thousand sensors. */
    @ParameterizedTest
    @CsvSource({"36", "1000"})
    void anItemAfterTheLastLetterHasNoMnemonic(int number) {
        runOnEdt(() -> {
            JMenuItem item = new JMenuItem();
            ContextMenu.number(item, number, "left");
            assertEquals("left", item.getText().strip());
            assertEquals(0, item.getMnemonic());
        });
    }
}
