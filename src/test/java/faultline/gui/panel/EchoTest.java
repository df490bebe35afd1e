package faultline.gui.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class EchoTest {

    @Test
    void whatTheUserAskedForShowsUntilTheWorldFollows() {
        Echo<String> echo = new Echo<>("old");
        echo.ask("new");
        assertEquals("new", echo.told("old"));
        assertEquals("new", echo.told("new"));
        assertEquals("newer", echo.told("newer"), "from then on the world leads");
    }

    @Test
    void whatNeverComesWasRefusedAndTheTruthShowsAgain() {
        Echo<String> echo = new Echo<>("old");
        echo.ask("new");
        for (int i = 0; i < Echo.PATIENCE; i++) {
            assertEquals("new", echo.told("old"));
        }
        assertEquals("old", echo.told("old"));
    }
}
