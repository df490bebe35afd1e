package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BufferedImageInputTest {

    private static final int SIGNATURE_AND_HEADER = 8 + 25;

    @TempDir
    private Path folder;

    /** A file that counts how often it is read. */
    private static final class CountingFile implements SeekableByteChannel {

        private final SeekableByteChannel file;
        private int reads;

        CountingFile(Path path) throws IOException {
            file = Files.newByteChannel(path);
        }

        @Override
        public int read(ByteBuffer bytes) throws IOException {
            reads++;
            return file.read(bytes);
        }

        @Override
        public int write(ByteBuffer bytes) throws IOException {
            return file.write(bytes);
        }

        @Override
        public long position() throws IOException {
            return file.position();
        }

        @Override
        public SeekableByteChannel position(long position) throws IOException {
            file.position(position);
            return this;
        }

        @Override
        public long size() throws IOException {
            return file.size();
        }

        @Override
        public SeekableByteChannel truncate(long size) throws IOException {
            file.truncate(size);
            return this;
        }

        @Override
        public boolean isOpen() {
            return file.isOpen();
        }

        @Override
        public void close() throws IOException {
            file.close();
        }
    }

    /** Writes an image of a white pixel with empty chunks that the reader skips. */
    private Path imageWithChunks(int count) throws IOException {
        BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
        image.getRaster().setSample(0, 0, 0, 255);
        ByteArrayOutputStream plain = new ByteArrayOutputStream();
        ImageIO.write(image, "png", plain);
        byte[] type = {'t', 'E', 'S', 't'};
        CRC32 sum = new CRC32();
        sum.update(type);
        byte[] chunk = ByteBuffer.allocate(12)
                .putInt(0)
                .put(type)
                .putInt((int) sum.getValue())
                .array();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(plain.toByteArray(), 0, SIGNATURE_AND_HEADER);
        for (int i = 0; i < count; i++) {
            out.write(chunk);
        }
        out.write(plain.toByteArray(), SIGNATURE_AND_HEADER, plain.size() - SIGNATURE_AND_HEADER);
        return Files.write(folder.resolve("chunks.png"), out.toByteArray());
    }

    @Test
    void anImageOfManySmallPartsIsReadInFewLargePieces() throws IOException {
        Path path = imageWithChunks(50_000);
        CountingFile file = new CountingFile(path);
        assertEquals(255, ImageIO.read(new BufferedImageInput(file)).getRaster().getSample(0, 0, 0));
        assertTrue(file.reads < 30, file.reads + " reads of " + Files.size(path) + " bytes");
        assertFalse(file.isOpen());
    }

    @Test
    void bytesAreThoseOfTheFileWhereverTheyAreRead() throws IOException {
        byte[] bytes = new byte[200_000];
        SplittableRandom random = new SplittableRandom(7);
        random.nextBytes(bytes);
        Path path = Files.write(folder.resolve("bytes"), bytes);
        try (BufferedImageInput in = new BufferedImageInput(Files.newByteChannel(path))) {
            assertEquals(bytes.length, in.length());
            for (int i = 0; i < 500; i++) {
                int from = random.nextInt(bytes.length);
                int length = Math.min(random.nextInt(100_000), bytes.length - from);
                byte[] read = new byte[length];
                in.seek(from);
                in.readFully(read);
                assertArrayEquals(Arrays.copyOfRange(bytes, from, from + length), read, "from " + from);
                assertEquals(from + length, in.getStreamPosition());
                assertEquals(from + length == bytes.length ? -1 : bytes[from + length] & 0xff, in.read());
            }
            in.seek(bytes.length - 1);
            assertThrows(EOFException.class, in::readShort);
        }
    }

    /** Readers of compressed images read a few bits and then whole bytes. */
    @Test
    void theByteAfterSomeBitsIsAWholeOne() throws IOException {
        Path path = Files.write(folder.resolve("bits"), new byte[] {(byte) 0b1010_0000, 5, 0b0100_0000, 7});
        try (BufferedImageInput in = new BufferedImageInput(Files.newByteChannel(path))) {
            assertEquals(0b101, in.readBits(3));
            in.readBits(5);
            assertEquals(5, in.read());
            assertEquals(0b01, in.readBits(2));
            assertEquals(0b0100_0000, in.read());
            assertEquals(0, in.getBitOffset());
            assertEquals(7, in.readBits(8));
        }
    }
}
