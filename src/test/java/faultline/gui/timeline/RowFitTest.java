package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RowFitTest {

    private static final RowFit.RowHeights HEIGHTS = new RowFit.RowHeights(13, 15, 17);

    @ParameterizedTest
    @CsvSource({
        "300, 11, 17, 11",
        "165, 11, 15, 11",
        "143, 11, 13, 11",
        "142, 11, 15, 9",
        "102, 11, 17, 6",
        "4, 11, 13, 1"
    })
    void allRowsAreVisibleOrAsManyOfAGoodHeightAsFit(int room, int count, int height, int rows) {
        assertEquals(new RowFit(height, rows), RowFit.of(room, count, HEIGHTS));
    }

    @Test
    void whatFitsIsWholeAndFitsAgainIntoItsOwnHeight() {
        for (int count = 1; count < 40; count++) {
            for (int room = 13; room < 500; room++) {
                RowFit fit = RowFit.of(room, count, HEIGHTS);
                assertTrue(fit.height() <= room && fit.rows() <= count, fit + " in " + room);
                assertEquals(fit, RowFit.of(fit.height(), count, HEIGHTS));
            }
        }
    }
}
