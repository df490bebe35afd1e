package faultline.floorplan;

import faultline.io.Message;
import faultline.io.MessageText;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.function.Supplier;

/** Reads portable grey maps, plain (P2) and raw (P5), with up to 16 bits per pixel. */
final class PgmReader {

    private static final int MAX_SAMPLE = 65535;
    private static final int MAX_WORD = 100;
    private static final int MAX_DIGITS = 30;

    private final Path file;
    private InputStream in;
    /** The number of bytes before the next one. */
    private long position;

    /** The next byte, or -1 at the end of the file. */
    private int next;

    /** The digits of the last number, which may be too large for an {@code int}. */
    private final StringBuilder digits = new StringBuilder();

    PgmReader(Path file, InputStream in) throws IOException {
        this.file = file;
        this.in = in;
        next = in.read();
    }

    MapImage read() throws IOException {
        advance();
        char format = (char) next;
        advance();
        if (format != '2' && format != '5') {
            throw new FloorPlanException(file, FloorPlanProblem.PORTABLE_FORMAT.with(format));
        }
        int width = readNumber(FloorPlanProblem.WIDTH::with);
        String widthText = digits();
        int height = readNumber(FloorPlanProblem.HEIGHT::with);
        String heightText = digits();
        int max = readNumber(FloorPlanProblem.MAX_VALUE::with);
        if (!MapImageReader.isPossible(width, height)) {
            throw new FloorPlanException(
                    file, FloorPlanProblem.IMAGE_SIZE.with(widthText, heightText, MapImage.MAX_PIXELS));
        }
        if (max < 1 || max > MAX_SAMPLE) {
            throw new FloorPlanException(file, FloorPlanProblem.MAX_SAMPLE.with(digits(), MAX_SAMPLE));
        }
        MapImage image = new MapImage(width, height, max);
        if (format == '2') {
            readPlain(image, max);
        } else {
            readRaw(image, max);
        }
        return image;
    }

    private void advance() throws IOException {
        next = in.read();
        position++;
    }

    private void readPlain(MapImage image, int max) throws IOException {
        for (int i = 0; i < image.width() * image.height(); i++) {
            int number = i + 1;
            int value = readNumber(() -> FloorPlanProblem.PIXEL.with(number));
            if (value > max) {
                throw new FloorPlanException(file, FloorPlanProblem.PIXEL_VALUE.with(number, digits(), max));
            }
            image.set(i, value, false);
        }
    }

    private void readRaw(MapImage image, int max) throws IOException {
        skipComment();
        int bytesEach = max < 256 ? 1 : 2;
        int count = image.width() * image.height();
        endHeader(count * bytesEach);
        long start = position;
        for (int i = 0; i < count; i++) {
            int value = nextRaw(start, count, bytesEach);
            if (bytesEach == 2) {
                value = value << 8 | nextRaw(start, count, bytesEach);
            }
            if (value > max) {
                throw new FloorPlanException(file, FloorPlanProblem.PIXEL_VALUE.with(i + 1, value, max));
            }
            image.set(i, value, false);
        }
    }

    /**
     * Skips the blank that ends the header, or the end of a comment right behind the maximum value. The lines of some
     * programs end with two bytes, but a line feed may also be the first pixel: the number of bytes left decides.
     */
    private void endHeader(int pixelBytes) throws IOException {
        boolean isCarriageReturn = next == '\r';
        advance();
        if (isCarriageReturn && next == '\n') {
            byte[] rest = in.readNBytes(pixelBytes + 1);
            in = new ByteArrayInputStream(rest);
            if (rest.length == pixelBytes) {
                advance();
            }
        }
    }

    private int nextRaw(long start, long count, int bytesEach) throws IOException {
        int value = next;
        if (value < 0) {
            throw new FloorPlanException(
                    file, FloorPlanProblem.TOO_FEW_BYTES.with(position - start, count * bytesEach));
        }
        advance();
        return value;
    }

    private int readNumber(Supplier<Message> name) throws IOException {
        skipBlanksAndComments();
        long begin = position;
        long number = 0;
        digits.setLength(0);
        while (next >= '0' && next <= '9') {
            if (digits.length() <= MAX_DIGITS) {
                digits.append((char) next);
            }
            number = Math.min(Integer.MAX_VALUE, number * 10 + next - '0');
            advance();
        }
        if (position == begin && next >= 0) {
            throw new FloorPlanException(file, FloorPlanProblem.WRONG_NUMBER.with(name.get(), readWord(), begin));
        }
        if (position == begin) {
            throw new FloorPlanException(file, FloorPlanProblem.MISSING_NUMBER.with(name.get(), begin));
        }
        return (int) number;
    }

    /** Returns the last number as the file has it, shortened if it is very long. */
    private String digits() {
        return digits.length() > MAX_DIGITS ? digits.substring(0, MAX_DIGITS) + "..." : digits.toString();
    }

    /** Returns the bytes before the next blank as text, shortened if there are many. */
    private String readWord() throws IOException {
        StringBuilder word = new StringBuilder();
        while (next >= 0 && !Character.isWhitespace(next) && word.length() < MAX_WORD) {
            word.append((char) next);
            advance();
        }
        return MessageText.excerpt(word.toString());
    }

    private void skipBlanksAndComments() throws IOException {
        while (next >= 0 && (Character.isWhitespace(next) || next == '#')) {
            skipComment();
            if (next >= 0) {
                advance();
            }
        }
    }

    /** Goes to the end of the line if a comment is next. */
    private void skipComment() throws IOException {
        boolean comment = next == '#';
        while (comment && next >= 0 && next != '\n' && next != '\r') {
            advance();
        }
    }
}
