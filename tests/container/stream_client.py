"""The smallest client of the stream: one WebSocket (RFC 6455) on a plain socket, until the first frame."""
import base64
import hashlib
import json
import os
import socket
import struct

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
HEADER_BYTES = 92  # of a frame message in cloudscape.v1


def receive(connection, size):
    data = b""
    while len(data) < size:
        part = connection.recv(size - len(data))
        if not part:
            raise ConnectionError("the server closed the connection")
        data += part
    return data


def send(connection, opcode, payload):
    mask = os.urandom(4)
    length = len(payload)
    size = bytes([0x80 | length]) if length < 126 else struct.pack(">BH", 0x80 | 126, length)
    masked = bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))
    connection.sendall(bytes([0x80 | opcode]) + size + mask + masked)


def receive_message(connection):
    """(opcode, payload) of a whole message, its fragments joined; pings are answered on the way."""
    first_opcode, payload = 0, b""
    while True:
        head, length = receive(connection, 2)
        if length == 126:
            length = struct.unpack(">H", receive(connection, 2))[0]
        elif length == 127:
            length = struct.unpack(">Q", receive(connection, 8))[0]
        opcode, body = head & 15, receive(connection, length)
        if opcode == PING:
            send(connection, PONG, body)
        elif opcode >= CLOSE:
            return opcode, body
        else:
            first_opcode, payload = first_opcode or opcode, payload + body
            if head & 0x80:
                return first_opcode, payload


def connect(port, token, timeout_s):
    connection = socket.create_connection(("127.0.0.1", port), timeout_s)
    key = base64.b64encode(os.urandom(16)).decode()
    connection.sendall((f"GET /api/v1/stream HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
                        f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n"
                        f"Sec-WebSocket-Protocol: cloudscape.v1\r\nAuthorization: Bearer {token}\r\n\r\n").encode())
    answer = b""
    while not answer.endswith(b"\r\n\r\n"):
        answer += receive(connection, 1)
    accept = base64.b64encode(hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest())
    if b" 101 " not in answer.split(b"\r\n")[0] or accept not in answer:
        raise ConnectionError(f"no WebSocket: {answer!r}")
    return connection


def first_frame(port, token, cloudscape, size_px, timeout_s=120):
    """The width, height and image bytes of the first frame that the server sends."""
    with connect(port, token, timeout_s) as connection:
        hello = {"type": "hello", "version": 1, "cloudscape": cloudscape, "size_px": size_px, "quality": "draft"}
        send(connection, TEXT, json.dumps(hello).encode())
        while True:
            opcode, payload = receive_message(connection)
            if opcode == BINARY:
                width, height = struct.unpack_from("<HH", payload, 16)
                return width, height, payload[HEADER_BYTES:]
            message = json.loads(payload) if opcode == TEXT else {"type": "close", "payload": repr(payload)}
            if message["type"] in ("error", "close"):
                raise ConnectionError(f"the stream ended: {message}")
