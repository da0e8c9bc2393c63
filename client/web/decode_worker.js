// The worker: compressed image in, VideoFrame or ImageBitmap out. ImageDecoder is several times faster where it exists
// (secure contexts of Chromium and Firefox); createImageBitmap works everywhere.

let has_image_decoder = typeof ImageDecoder !== 'undefined';

async function decode_fast(type, image) {
  const decoder = new ImageDecoder({ type, data: image });
  try {
    return (await decoder.decode()).image;
  } finally {
    decoder.close();
  }
}

async function decode(type, image) {
  if (has_image_decoder) {
    try {
      return await decode_fast(type, image);
    } catch {
      has_image_decoder = await ImageDecoder.isTypeSupported(type).catch(() => false);
    }
  }
  return createImageBitmap(new Blob([image], { type }));
}

self.onmessage = async ({ data }) => {
  try {
    const image = await decode(data.type, data.image);
    self.postMessage({ image }, [image]);
  } catch (error) {
    self.postMessage({ reason: String(error) });
  }
};
