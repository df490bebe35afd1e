package faultline.engine.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rows of any cells have the text that plain code writes. */
class TraceTextTest {

    private static final List<String> LONG_WORDS = List.of("", "off", "w".repeat(300), "é".repeat(3000));

    @ParameterizedTest
    @ValueSource(ints = {2, 63, 64, 65, 200})
    void rowsOfRandomCellsAreThoseOfPlainCode(int columns) throws IOException {
        Random random = new Random(columns);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        StringBuilder expected = new StringBuilder();
        TraceText text = new TraceText(columns);
        TraceRows rows = new TraceRows(columns, 1 + random.nextInt(500));
        Object[] cells = new Object[columns];
        for (int row = 0; row < 1500; row++) {
            cells[0] = row;
            rows.append(row);
            for (int column = 1; column < columns; column++) {
                if (row > 0 && random.nextInt(4) > 0) {
                    rows.repeat(1);
                    continue;
                }
                cells[column] = randomCell(random, cells[column - 1]);
                if (cells[column] instanceof Double number) {
                    rows.append(number);
                } else {
                    rows.append(cells[column].toString());
                }
            }
            rows.endRow();
            expected.append(plainRow(cells));
            if (rows.isFull()) {
                text.write(rows, out);
                rows.clear();
            }
        }
        text.write(rows, out);
        assertEquals(expected.toString(), out.toString(StandardCharsets.UTF_8));
    }

    private static Object randomCell(Random random, Object left) {
        return switch (random.nextInt(5)) {
            case 0 -> LONG_WORDS.get(random.nextInt(LONG_WORDS.size()));
            case 1 -> random.nextBoolean() ? Double.NaN : Double.POSITIVE_INFINITY;
            case 2 -> left instanceof Double ? left : -1.7976931348623157E308;
            default -> random.nextGaussian();
        };
    }

    private static String plainRow(Object[] cells) {
        List<String> texts = new ArrayList<>();
        for (Object cell : cells) {
            texts.add(cell instanceof Double number && !Double.isFinite(number) ? "" : cell.toString());
        }
        return String.join(",", texts) + "\n";
    }

    @Test
    void aRowOfWordsMayFillItsRoomExactly() throws IOException {
        for (int length = 4090; length <= 4100; length++) {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            TraceText text = new TraceText(1);
            text.append(List.of("n".repeat(length)));
            TraceRows rows = new TraceRows(1, 1);
            rows.append(0);
            rows.endRow();
            text.write(rows, out);
            assertEquals("n".repeat(length) + "\n0\n", out.toString(StandardCharsets.UTF_8));
        }
    }
}
