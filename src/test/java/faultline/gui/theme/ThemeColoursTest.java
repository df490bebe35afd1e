package faultline.gui.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.GuiRobot;
import faultline.paint.surface.Contrast;
import java.awt.Color;
import java.util.List;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ThemeColoursTest {

    @ParameterizedTest
    @EnumSource(Theme.class)
    void textContrastsWithEveryBackground(Theme theme) {
        ThemeColours c = theme.colours();
        for (Color ground : List.of(c.background(), c.field(), c.hover(), c.pressed())) {
            assertContrast(4.5, c.text(), ground);
        }
        assertContrast(4.5, c.muted(), c.background());
        assertContrast(4.5, c.muted(), c.field());
        assertContrast(4.5, c.onAccent(), c.accent());
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void numbersThatDoNotApplyCanStillBeRead(Theme theme) {
        GuiRobot.runOnEdt(() -> {
            theme.install();
            JSpinner spinner = new JSpinner();
            spinner.setEnabled(false);
            JTextField number = ((JSpinner.DefaultEditor) spinner.getEditor()).getTextField();
            assertContrast(4.5, number.getDisabledTextColor(), theme.colours().field());
        });
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void controlsAndTheirStatesContrastWithTheBackground(Theme theme) {
        ThemeColours c = theme.colours();
        for (Color ground : List.of(c.background(), c.field())) {
            assertContrast(3, c.border(), ground);
            assertContrast(3, c.accent(), ground);
            assertContrast(3, c.warning(), ground);
        }
    }

    @Test
    void theContrastOfBlackAndWhiteIsTwentyOne() {
        assertEquals(21, Contrast.of(Color.BLACK, Color.WHITE), 1e-9);
        assertEquals(1, Contrast.of(Color.GRAY, Color.GRAY), 1e-9);
    }

    private static void assertContrast(double least, Color one, Color other) {
        double contrast = Contrast.of(one, other);
        assertTrue(contrast >= least, one + " on " + other + ": " + contrast);
    }
}
