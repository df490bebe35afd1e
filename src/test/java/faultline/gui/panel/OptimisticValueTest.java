package faultline.gui.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class OptimisticValueTest {

    @Test
    void whatTheUserAskedForShowsUntilTheWorldFollows() {
        OptimisticValue<String> echo = new OptimisticValue<>("old");
        echo.request("new");
        assertEquals("new", echo.update("old"));
        assertEquals("new", echo.update("new"));
        assertEquals("newer", echo.update("newer"), "from then on the world leads");
    }

    @Test
    void whatNeverComesWasRefusedAndTheTruthShowsAgain() {
        OptimisticValue<String> echo = new OptimisticValue<>("old");
        echo.request("new");
        for (int i = 0; i < OptimisticValue.TIMEOUT_SNAPSHOTS; i++) {
            assertEquals("new", echo.update("old"));
        }
        assertEquals("old", echo.update("old"));
    }
}
