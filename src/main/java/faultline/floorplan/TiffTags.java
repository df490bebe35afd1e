package faultline.floorplan;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Set;
import java.util.stream.IntStream;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.plugins.tiff.BaselineTIFFTagSet;
import javax.imageio.plugins.tiff.TIFFDirectory;
import javax.imageio.plugins.tiff.TIFFField;

/** The tags of a TIFF file that state what its samples mean. */
final class TiffTags {

    private static final Set<Integer> SINGLE_SAMPLE_BITS = Set.of(1, 2, 4, 8, 16);
    private static final Set<Integer> SAMPLE_BITS = Set.of(8, 16);
    private static final int RGB_SAMPLES = 3;
    private static final int RGBA_SAMPLES = 4;
    private static final int FLOAT_BITS = 32;

    private final Path file;
    private final TIFFDirectory directory;
    private final int[] bits;
    private final int photometric;

    TiffTags(Path file, IIOMetadata metadata) throws IIOInvalidTreeException {
        this.file = file;
        directory = TIFFDirectory.createFromMetadata(metadata);
        int samples = number(BaselineTIFFTagSet.TAG_SAMPLES_PER_PIXEL, 1);
        int[] sizes = numbers(BaselineTIFFTagSet.TAG_BITS_PER_SAMPLE, 1);
        bits = Arrays.copyOf(sizes, samples);
        if (sizes.length < samples) {
            // The JDK takes the first size for that of all samples, too.
            Arrays.fill(bits, sizes[0]);
        }
        photometric = number(BaselineTIFFTagSet.TAG_PHOTOMETRIC_INTERPRETATION, usualPhotometric());
    }

    /** Returns what the JDK assumes if a file does not state the meaning of its colours. */
    private int usualPhotometric() {
        if (directory.containsTIFFField(BaselineTIFFTagSet.TAG_COLOR_MAP)) {
            return BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_PALETTE_COLOR;
        }
        return bits.length == RGB_SAMPLES || bits.length == RGBA_SAMPLES
                ? BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_RGB
                : BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_BLACK_IS_ZERO;
    }

    /**
     * {@return which samples are the colours and the opacity}
     *
     * @throws FloorPlanException if the JDK does not read such samples or reads them wrongly
     */
    PixelLayout layout() throws FloorPlanException {
        int compression = number(BaselineTIFFTagSet.TAG_COMPRESSION, BaselineTIFFTagSet.COMPRESSION_NONE);
        if (compression == BaselineTIFFTagSet.COMPRESSION_JPEG
                || compression == BaselineTIFFTagSet.COMPRESSION_OLD_JPEG) {
            throw new FloorPlanException(file, FloorPlanProblem.COMPRESSION.with("JPEG"));
        }
        if (photometric < 0 || photometric > BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_PALETTE_COLOR) {
            throw new FloorPlanException(file, FloorPlanProblem.PHOTOMETRIC.with(photometric));
        }
        if (photometric == BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_PALETTE_COLOR && bits.length > 1) {
            throw new FloorPlanException(file, FloorPlanProblem.PALETTE_SAMPLES.with(bits.length));
        }
        if (IntStream.of(sampleFormats())
                .anyMatch(format -> format == BaselineTIFFTagSet.SAMPLE_FORMAT_SIGNED_INTEGER)) {
            throw new FloorPlanException(file, FloorPlanProblem.SIGNED_SAMPLES.with());
        }
        requireBits();
        boolean isRgb = photometric == BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_RGB && bits.length >= RGB_SAMPLES;
        int colors = isRgb ? RGB_SAMPLES : 1;
        return new PixelLayout(colors, opacity(colors));
    }

    private void requireBits() throws FloorPlanException {
        int size = bits[0];
        if (bits.length == 1 && !SINGLE_SAMPLE_BITS.contains(size)) {
            throw new FloorPlanException(file, FloorPlanProblem.PIXEL_BITS.with(size));
        }
        boolean isEqual = Arrays.stream(bits).allMatch(other -> other == size);
        if (bits.length > 1 && !isPacked() && !isFloat() && !(isEqual && SAMPLE_BITS.contains(size))) {
            int wrong = Arrays.stream(bits)
                    .filter(other -> !SAMPLE_BITS.contains(other))
                    .findFirst()
                    .orElse(size);
            throw new FloorPlanException(file, FloorPlanProblem.SAMPLE_BITS.with(wrong));
        }
    }

    /** Returns whether the JDK packs the samples of a pixel into a number, which it does with samples of any size. */
    private boolean isPacked() {
        return isRgbOrRgba() && Arrays.stream(bits).sum() <= Integer.SIZE;
    }

    /** Returns whether the JDK converts the samples from floating-point numbers. */
    private boolean isFloat() {
        return isRgbOrRgba()
                && Arrays.stream(bits).allMatch(size -> size == FLOAT_BITS)
                && sampleFormats()[0] == BaselineTIFFTagSet.SAMPLE_FORMAT_FLOATING_POINT;
    }

    private int[] sampleFormats() {
        return numbers(BaselineTIFFTagSet.TAG_SAMPLE_FORMAT, BaselineTIFFTagSet.SAMPLE_FORMAT_UNSIGNED_INTEGER);
    }

    private boolean isRgbOrRgba() {
        return photometric == BaselineTIFFTagSet.PHOTOMETRIC_INTERPRETATION_RGB
                && (bits.length == RGB_SAMPLES || bits.length == RGBA_SAMPLES);
    }

    /** Returns the index of the sample of the opacity, negative if there is none. */
    private int opacity(int colors) {
        int extraSamples = bits.length - colors;
        // Most programs take a single further sample of no stated type for the opacity, as the JDK does.
        int usualType = extraSamples == 1
                ? BaselineTIFFTagSet.EXTRA_SAMPLES_UNASSOCIATED_ALPHA
                : BaselineTIFFTagSet.EXTRA_SAMPLES_UNSPECIFIED;
        int[] types = numbers(BaselineTIFFTagSet.TAG_EXTRA_SAMPLES, usualType);
        for (int i = 0; i < Math.min(types.length, extraSamples); i++) {
            if (types[i] == BaselineTIFFTagSet.EXTRA_SAMPLES_ASSOCIATED_ALPHA
                    || types[i] == BaselineTIFFTagSet.EXTRA_SAMPLES_UNASSOCIATED_ALPHA) {
                return colors + i;
            }
        }
        return -1;
    }

    private int number(int tag, int usual) {
        return numbers(tag, usual)[0];
    }

    /** Returns the values of a tag; one usual value if the file does not have the tag. */
    private int[] numbers(int tag, int usual) {
        TIFFField field = directory.getTIFFField(tag);
        return field == null
                ? new int[] {usual}
                : IntStream.range(0, field.getCount()).map(field::getAsInt).toArray();
    }
}
