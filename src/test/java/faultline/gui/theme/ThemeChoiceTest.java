package faultline.gui.theme;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ThemeChoiceTest {

    @ParameterizedTest
    @CsvSource({"Adwaita, LIGHT", "Adwaita-dark, DARK", "Yaru-Dark, DARK", "Mint-Y-Aqua, LIGHT", ", LIGHT"})
    void aDesktopThemeIsDarkIfItsNameSaysSo(String name, Theme theme) {
        assertEquals(theme, ThemeChoice.themeOfDesktop(name));
    }

    @Test
    void aFixedChoiceDoesNotDependOnTheDesktop() {
        assertEquals(Theme.LIGHT, ThemeChoice.LIGHT.theme());
        assertEquals(Theme.DARK, ThemeChoice.DARK.theme());
    }
}
