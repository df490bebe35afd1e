package faultline.gui.panel;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import faultline.gui.theme.Theme;
import java.text.ParseException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class NumberSpinnerTest {

    private final List<Double> told = new ArrayList<>();
    private NumberSpinner spinner;

    @BeforeEach
    void make() {
        spinner = onEdt(() -> {
            Theme.LIGHT.install();
            return new NumberSpinner("0.00##", 0.01, 100, 0.05, told::add).named("Range");
        });
    }

    @Test
    void followingTheWorldTellsNobody() {
        edt(() -> spinner.follow(0.8));
        assertEquals("0.80", onEdt(() -> spinner.text().getText()));
        assertEquals(List.of(), told);
    }

    @Test
    void aNumberFromTheUserIsToldOnce() {
        commit("1,25");
        assertEquals(List.of(1.25), told);
        assertEquals("1.25", onEdt(() -> spinner.text().getText()));
    }

    @Test
    void aNumberBeyondTheLimitsIsNotTaken() {
        edt(() -> spinner.follow(0.8));
        edt(() -> {
            spinner.text().setText("500");
            assertFalse(spinner.text().isEditValid(), "the outline shows it while it is typed");
            assertThrows(ParseException.class, spinner.text()::commitEdit);
        });
        assertEquals(List.of(), told);
        assertEquals(0.8, onEdt(spinner::value));
    }

    @Test
    void theWorldMayHaveANumberThatTheUserMayNotGive() {
        edt(() -> spinner.follow(250));
        assertEquals("250.00", onEdt(() -> spinner.text().getText()));
    }

    @Test
    void anUpwardArrowGoesAStepUp() {
        edt(() -> spinner.follow(0.8));
        edt(() -> spinner.setValue(spinner.getNextValue()));
        assertEquals(0.85, told.get(0), 1e-12);
    }

    private void commit(String text) {
        edt(() -> {
            spinner.text().setText(text);
            try {
                spinner.text().commitEdit();
            } catch (ParseException refused) {
                throw new AssertionError(refused);
            }
        });
    }
}
