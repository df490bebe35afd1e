package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ByteCountTest {

    @ParameterizedTest
    @CsvSource({
        "0, 0 B",
        "1023, 1023 B",
        "1024, 1 KiB",
        "1536, 1.5 KiB",
        "1047552, 1023 KiB",
        "1048575, 1 MiB",
        "1048576, 1 MiB",
        "16777216, 16 MiB",
        "16777217, 16.1 MiB",
        "536870912, 512 MiB",
        "1073741825, 1.1 GiB",
        "9223372036854775807, 8 EiB"
    })
    void aSizeIsReadableAndWhatExceedsALimitLooksLarger(long bytes, String text) {
        assertEquals(text, ByteCount.format(bytes));
    }
}
