package faultline.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.util.List;
import java.util.Locale;
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

    @Test
    void whatATestHasChosenIsRestored() {
        EdtChecker checker = new EdtChecker();
        Locale before = Locale.getDefault();
        checker.beforeEach(null);
        GuiRobot.runOnEdt(() -> {
            Locale.setDefault(Locale.forLanguageTag("pl-PL"));
            Messages.setLanguage(Language.POLISH);
            TextSize.LARGEST.install();
            Theme.DARK.install();
        });
        checker.afterEach(null);
        assertEquals(before, Locale.getDefault());
        assertEquals(Language.ENGLISH, GuiRobot.callOnEdt(Messages::language));
        assertEquals(TextSize.NORMAL, GuiRobot.callOnEdt(TextSize::current));
        assertEquals(Theme.LIGHT, GuiRobot.callOnEdt(Theme::current));
    }
}
