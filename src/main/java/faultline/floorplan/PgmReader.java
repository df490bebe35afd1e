package faultline.floorplan;

import java.nio.file.Path;

/** Reads portable grey maps, plain (P2) and raw (P5), with up to 16 bits per pixel. */
final class PgmReader {

    private final Path file;
    private final byte[] bytes;
    private int next = 2;

    PgmReader(Path file, byte[] bytes) {
        this.file = file;
        this.bytes = bytes;
    }

    MapImage read() throws FloorPlanException {
        char format = (char) bytes[1];
        if (format != '2' && format != '5') {
            throw new FloorPlanException(file + ": the format of the image is P" + format + "; expected P2 or P5");
        }
        int width = readHeaderNumber("the width");
        int height = readHeaderNumber("the height");
        int max = readHeaderNumber("the maximum value");
        MapImageReader.requireSize(file, width, height);
        if (max < 1 || max > 65535) {
            throw new FloorPlanException(file + ": the maximum value is " + max + "; expected 1 to 65535");
        }
        MapImage image = new MapImage(width, height);
        if (format == '2') {
            readPlain(image, max);
        } else {
            readRaw(image, max);
        }
        return image;
    }

    private void readPlain(MapImage image, int max) throws FloorPlanException {
        for (int i = 0; i < image.width() * image.height(); i++) {
            set(image, i, readHeaderNumber("pixel " + (i + 1)), max);
        }
    }

    private void readRaw(MapImage image, int max) throws FloorPlanException {
        next++; // exactly one blank ends the header
        int bytesEach = max < 256 ? 1 : 2;
        int count = image.width() * image.height();
        if (bytes.length - next < (long) count * bytesEach) {
            throw new FloorPlanException(file + ": the image ends after " + Math.max(0, bytes.length - next)
                    + " bytes of pixels, " + (long) count * bytesEach + " are needed");
        }
        for (int i = 0; i < count; i++) {
            int value = bytes[next++] & 0xff;
            if (bytesEach == 2) {
                value = value << 8 | bytes[next++] & 0xff;
            }
            set(image, i, value, max);
        }
    }

    private void set(MapImage image, int index, int value, int max) throws FloorPlanException {
        if (value > max) {
            throw new FloorPlanException(file + ": pixel " + (index + 1) + " is " + value + "; expected 0 to " + max);
        }
        image.set(index, max == 255 ? value : value * 255f / max, false);
    }

    private int readHeaderNumber(String what) throws FloorPlanException {
        skipBlanksAndComments();
        int begin = next;
        long number = 0;
        while (next < bytes.length && bytes[next] >= '0' && bytes[next] <= '9') {
            number = Math.min(Integer.MAX_VALUE, number * 10 + bytes[next++] - '0');
        }
        if (next == begin) {
            throw new FloorPlanException(file + ": " + what + " is missing at byte " + begin);
        }
        return (int) number;
    }

    private void skipBlanksAndComments() {
        while (next < bytes.length && (Character.isWhitespace(bytes[next]) || bytes[next] == '#')) {
            if (bytes[next++] == '#') {
                while (next < bytes.length && bytes[next] != '\n' && bytes[next] != '\r') {
                    next++;
                }
            }
        }
    }
}
