package faultline.floorplan;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SortedMap;
import java.util.TreeMap;

/** A TIFF file of one row without compression, with any tags, also those that the JDK does not write. */
final class TiffFile {

    static final int BITS = 258;
    static final int COMPRESSION = 259;
    static final int PHOTOMETRIC = 262;
    static final int COLOR_MAP = 320;
    static final int EXTRA_SAMPLES = 338;
    static final int SAMPLE_FORMAT = 339;
    static final int PROFILE = 34675;

    private static final int FIRST_PIXEL = 8;

    private final SortedMap<Integer, int[]> tags = new TreeMap<>();

    /** Creates a file of pixels that have samples of the given bits. */
    TiffFile(int photometric, int... bits) {
        with(BITS, bits).with(COMPRESSION, 1).with(PHOTOMETRIC, photometric).with(277, bits.length);
    }

    /** Replaces a tag; no values remove it. */
    TiffFile with(int tag, int... values) {
        tags.put(tag, values);
        if (values.length == 0) {
            tags.remove(tag);
        }
        return this;
    }

    TiffFile withProfile(byte... profile) {
        int[] values = new int[profile.length];
        Arrays.setAll(values, i -> profile[i]);
        return with(PROFILE, values);
    }

    /** Writes the file, given the samples of all pixels. */
    Path write(Path file, int... samples) throws IOException {
        int[] bits = tags.get(BITS);
        StringBuilder row = new StringBuilder();
        for (int i = 0; i < samples.length; i++) {
            int size = bits[i % bits.length];
            row.append(Integer.toBinaryString(1 << size | samples[i]).substring(1));
        }
        byte[] pixels = new byte[(row.length() + 15) / 16 * 2];
        for (int i = 0; i < row.length(); i++) {
            pixels[i / 8] |= (byte) (row.charAt(i) - '0' << 7 - i % 8);
        }
        with(256, samples.length / bits.length)
                .with(257, 1)
                .with(273, FIRST_PIXEL)
                .with(278, 1);
        with(279, pixels.length);
        return Files.write(file, bytes(pixels));
    }

    private byte[] bytes(byte[] pixels) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeInt('M' << 24 | 'M' << 16 | 42);
        out.writeInt(FIRST_PIXEL + pixels.length);
        out.write(pixels);
        out.writeShort(tags.size());
        ByteArrayOutputStream longValues = new ByteArrayOutputStream();
        int longStart = FIRST_PIXEL + pixels.length + 2 + 12 * tags.size() + 4;
        for (var tag : tags.entrySet()) {
            boolean isProfile = tag.getKey() == PROFILE;
            ByteArrayOutputStream value = new ByteArrayOutputStream();
            for (int number : tag.getValue()) {
                if (!isProfile) {
                    value.write(number >> 8);
                }
                value.write(number);
            }
            out.writeShort(tag.getKey());
            out.writeShort(isProfile ? 7 : 3);
            out.writeInt(tag.getValue().length);
            if (value.size() > 4) {
                out.writeInt(longStart + longValues.size());
                value.writeTo(longValues);
            } else {
                out.write(Arrays.copyOf(value.toByteArray(), 4));
            }
        }
        out.writeInt(0);
        longValues.writeTo(out);
        return bytes.toByteArray();
    }
}
